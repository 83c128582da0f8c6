#include "tagmint/codec/rotation.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::codec {
namespace {

/// The picture turned by 90 degrees counter-clockwise as seen: the right edge comes to the top.
TagCells turn_picture(const TagCells& cells) {
  const int width = cells.width();
  std::vector<Cell> turned;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) turned.push_back(cells.at(width - 1 - y, x));
  }
  return TagCells(width, std::move(turned));
}

/// Some word with no symmetry, in the low `bits` bits.
Codeword sample_word(int bits) { return 0x9e3779b97f4a7c15u & low_mask(bits); }

TEST(Rotation, FourQuarterTurnsAreTheIdentity) {
  for (const int bits : {1, 4, 5, 16, 21, 25, 36, 41, 48, 49, 52, 64}) {
    const Codeword word = sample_word(bits);
    EXPECT_EQ(rotate(word, bits, 4), word) << bits;
    EXPECT_EQ(rotate(rotate(word, bits, 1), bits, 3), word) << bits;
    EXPECT_EQ(rotate(word, bits, -1), rotate(word, bits, 3)) << bits;
  }
}

TEST(Rotation, OfAWordIsTheWordOfTheTurnedPicture) {
  for (const char* name :
       {"classic:8", "classic:9", "standard:9", "circle:9", "circle:11", "classic:12"}) {
    const Layout layout = parse_layout(name);
    const Codeword word = sample_word(layout.bits());
    const TagCells turned = turn_picture(tag_cells(layout, word));
    EXPECT_EQ(codeword_of(layout, turned), rotate_quarter(word, layout.bits())) << name;
  }
}

TEST(Rotation, DistanceIsTheLeastOverTheFourTurns) {
  EXPECT_EQ(rotation_distance(0x000f, 0xf000, 16), 0);
  EXPECT_EQ(rotation_distance(0x000f, 0xf001, 16), 1);
  EXPECT_EQ(rotation_distance(0x000f, 0x00ff, 16), 4);
}

TEST(Rotation, SelfDistanceComparesQuarterAndHalfTurns) {
  EXPECT_EQ(self_distance(0x000f, 16), 8);
  EXPECT_EQ(self_distance(0x0f0f, 16), 0);  // the half turn changes nothing
  EXPECT_EQ(self_distance(0x1000f, 17), 8) << "the centre bit never moves";
}

}  // namespace
}  // namespace tagmint::codec
