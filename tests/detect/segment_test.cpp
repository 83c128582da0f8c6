#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "pipeline/s3_segment.h"
#include "support/ascii_image.h"
#include "support/fixed_random.h"

namespace tagmint::detect {
namespace {

using testing::ascii_image;
using Rows = std::vector<std::string>;

Labels run(ImageView image) {
  SegmentScratch scratch;
  Labels labels;
  segment(image, scratch, labels);
  return labels;
}

/// Labels as letters, 'a' = 0; '-' = no component.
Rows letters(const Labels& labels) {
  Rows rows(labels.height);
  for (int i = 0; i < labels.width * labels.height; ++i) {
    const std::uint32_t label = labels.label[i];
    rows[i / labels.width] += label == kNoComponent ? '-' : static_cast<char>('a' + label);
  }
  return rows;
}

/// Components by flood fill from each pixel that has none yet.
Labels flood_fill(const Image& image) {
  Labels out{image.width(), image.height(), {}, {}};
  out.label.assign(std::size_t(image.width()) * image.height(), kNoComponent);
  for (int start = 0; start < image.width() * image.height(); ++start) {
    const int value = image.at(start % image.width(), start / image.width());
    if (value == kUnknown || out.label[start] != kNoComponent) continue;
    const auto label = static_cast<std::uint32_t>(out.size.size());
    out.size.push_back(0);
    std::vector<int> open{start};
    out.label[start] = label;
    while (!open.empty()) {
      const int x = open.back() % image.width(), y = open.back() / image.width();
      open.pop_back();
      ++out.size[label];
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int u = x + dx, v = y + dy;
          if (u < 0 || v < 0 || u >= image.width() || v >= image.height()) continue;
          if (value == kBlack && dx != 0 && dy != 0) continue;
          std::uint32_t& there = out.label[v * image.width() + u];
          if (image.at(u, v) != value || there != kNoComponent) continue;
          there = label;
          open.push_back(v * image.width() + u);
        }
      }
    }
  }
  return out;
}

TEST(Segment, WhiteHoldsTogetherAcrossCornersAndBlackDoesNot) {
  EXPECT_EQ(letters(run(ascii_image({"#.",  //
                                     ".#"}))),
            (Rows{"ab",  //
                  "bc"}));
}

TEST(Segment, BlackPixelsThatShareAnEdgeHoldTogether) {
  EXPECT_EQ(letters(run(ascii_image({"#.#.#",  //
                                     "#.###",  //
                                     "#....",  //
                                     "#####"}))),
            (Rows{"abcdc",  //
                  "abccc",  //
                  "abbbb",  //
                  "aaaaa"}));
}

TEST(Segment, UnknownPixelsBelongToNoComponentAndPartOthers) {
  EXPECT_EQ(letters(run(ascii_image({"#?#",  //
                                     "???",  //
                                     ".?."}))),
            (Rows{"a-b",  //
                  "---",  //
                  "c-d"}));
}

TEST(Segment, SizesCountPixels) {
  const Labels labels = run(ascii_image({"##..",  //
                                         "#...",  //
                                         "??.#"}));
  EXPECT_EQ(labels.size, (std::vector<std::uint32_t>{3, 6, 1}));
}

TEST(Segment, ASpiralIsOneComponentForEachColour) {
  const Labels labels = run(ascii_image({"#########",  //
                                         "#.......#",  //
                                         "#.#####.#",  //
                                         "#.#...#.#",  //
                                         "#.#.#.#.#",  //
                                         "#.#.###.#",  //
                                         "#.#.....#",  //
                                         "#.#######",  //
                                         "#........"}));
  EXPECT_EQ(labels.size.size(), 2u);
  EXPECT_EQ(labels.size[0] + labels.size[1], 81u);
}

TEST(Segment, AgreesWithFloodFillOnRandomPicturesOfOddSizes) {
  testing::FixedRandom random(5);
  for (int round = 0; round < 150; ++round) {
    const int width = random.between(0, 37), height = random.between(0, 23);
    const int unknown = random.between(0, 40), stickiness = random.between(0, 90);
    Image image(width, height);
    std::uint8_t value = kBlack;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (random.between(0, 99) >= stickiness) {
          value = random.between(0, 99) < unknown ? kUnknown
                  : random.between(0, 1)          ? kWhite
                                                  : kBlack;
        }
        image.at(x, y) = value;
      }
    }
    const Labels fast = run(image), slow = flood_fill(image);
    EXPECT_EQ(fast.label, slow.label) << width << " x " << height << ", round " << round;
    EXPECT_EQ(fast.size, slow.size);
  }
}

TEST(Segment, BuffersOfALargerImageDoNotShowInASmallerOne) {
  SegmentScratch scratch;
  Labels labels;
  segment(Image(30, 30, kWhite), scratch, labels);
  segment(ascii_image({"#.#"}), scratch, labels);
  EXPECT_EQ(letters(labels), (Rows{"abc"}));
  EXPECT_EQ(labels.size, (std::vector<std::uint32_t>{1, 1, 1}));
}

}  // namespace
}  // namespace tagmint::detect
