#include "search/leaf_paint.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "support/instruction_sets.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::with_every_instruction_set;

NearList random_centres(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  NearList list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(near_entry(random(), 0));
  return list;
}

TEST(LeafPainter, PaintsHammingBallsWithEveryInstructionSet) {
  const LeafPainter painter;
  with_every_instruction_set([&] {
    for (const std::size_t count : {0, 1, 3}) {
      const NearList list = random_centres(count, 10);
      for (const int radius : {0, 1, 3, 6, 9, 12, 16, 40}) {
        for (int depth = 0; depth <= LeafPainter::kMostDepth; ++depth) {
          TwigBits painted{};
          TwigBits expected{};
          painter.paint(list, radius, depth, painted);
          LeafPainter::paint_scalar(list, radius, depth, expected);
          ASSERT_EQ(painted.elements, expected.elements)
              << count << " balls of radius " << radius << ", " << depth << " rows deep";
        }
      }
    }
  });
}

TEST(LeafPainter, KeepsWhatIsPainted) {
  const LeafPainter painter;
  TwigBits twig{};
  twig.elements[1] = 5;
  NearList list;
  list.push_back(near_entry(0x40, 0));
  painter.paint(list, 0, LeafPainter::kMostDepth, twig);
  EXPECT_EQ(twig.elements[1], 5u) << "bit 0 was there";
  list.clear();
  list.push_back(near_entry(0x41, 0));
  painter.paint(list, 0, LeafPainter::kMostDepth, twig);
  EXPECT_EQ(twig.elements[1], 7u);
}

TEST(LeafPainter, TellsWhatIsNotPaintedWithEveryInstructionSet) {
  with_every_instruction_set([] {
    TwigBits twig;
    twig.elements.fill(~std::uint64_t{0});
    std::vector<std::uint32_t> unpainted;
    for (unsigned leaf = 0; leaf < 16; ++leaf) {
      LeafPainter::append_unpainted(twig, leaf, 0, unpainted);
    }
    EXPECT_TRUE(unpainted.empty());
    for (const unsigned word : {0x3000, 0x3001, 0x37ff, 0x3abc, 0x3fff}) {
      twig.elements[word / 64] ^= std::uint64_t{1} << (word % 64);
    }
    LeafPainter::append_unpainted(twig, 2, 0xab0000, unpainted);
    EXPECT_TRUE(unpainted.empty());
    LeafPainter::append_unpainted(twig, 3, 0xab0000, unpainted);
    EXPECT_EQ(unpainted,
              (std::vector<std::uint32_t>{0xab3000, 0xab3001, 0xab37ff, 0xab3abc, 0xab3fff}));
  });
}

}  // namespace
}  // namespace tagmint::codec
