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

Components run(ImageView image) {
  SegmentScratch scratch;
  Components components;
  segment(image, scratch, components);
  return components;
}

/// Components as letters, 'a' = 0; '-' = none.
Rows letters(const Components& components) {
  Rows rows(components.height);
  const std::vector<std::uint32_t> of_pixel = component_of_each_pixel(components);
  for (int i = 0; i < components.width * components.height; ++i) {
    const char letter = static_cast<char>('a' + of_pixel[i]);
    rows[i / components.width] += of_pixel[i] == kNoComponent ? '-' : letter;
  }
  return rows;
}

struct Filled {
  std::vector<std::uint32_t> of_pixel;
  std::vector<std::uint32_t> size;
};

/// Components by flood fill from each pixel that has none yet.
Filled flood_fill(const Image& image) {
  Filled out;
  out.of_pixel.assign(std::size_t(image.width()) * image.height(), kNoComponent);
  for (int start = 0; start < image.width() * image.height(); ++start) {
    const int value = image.at(start % image.width(), start / image.width());
    if (value == kUnknown || out.of_pixel[start] != kNoComponent) continue;
    const auto label = static_cast<std::uint32_t>(out.size.size());
    out.size.push_back(0);
    std::vector<int> open{start};
    out.of_pixel[start] = label;
    while (!open.empty()) {
      const int x = open.back() % image.width(), y = open.back() / image.width();
      open.pop_back();
      ++out.size[label];
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int u = x + dx, v = y + dy;
          if (u < 0 || v < 0 || u >= image.width() || v >= image.height()) continue;
          if (value == kBlack && dx != 0 && dy != 0) continue;
          std::uint32_t& there = out.of_pixel[v * image.width() + u];
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
  const Components components = run(ascii_image({"##..",  //
                                                 "#...",  //
                                                 "??.#"}));
  EXPECT_EQ(components.size, (std::vector<std::uint32_t>{3, 6, 1}));
}

TEST(Segment, ASpiralIsOneComponentForEachColour) {
  const Components components = run(ascii_image({"#########",  //
                                                 "#.......#",  //
                                                 "#.#####.#",  //
                                                 "#.#...#.#",  //
                                                 "#.#.#.#.#",  //
                                                 "#.#.###.#",  //
                                                 "#.#.....#",  //
                                                 "#.#######",  //
                                                 "#........"}));
  EXPECT_EQ(components.size.size(), 2u);
  EXPECT_EQ(components.size[0] + components.size[1], 81u);
}

/// The smallest boxes about the components, pixel by pixel.
std::vector<PixelBox> boxes_of(const Filled& filled, int width) {
  std::vector<PixelBox> boxes(filled.size.size(), {1 << 30, 1 << 30, 0, 0});
  for (std::size_t i = 0; i < filled.of_pixel.size(); ++i) {
    if (filled.of_pixel[i] == kNoComponent) continue;
    PixelBox& box = boxes[filled.of_pixel[i]];
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    box.left = std::min(box.left, x);
    box.top = std::min(box.top, y);
    box.right = std::max(box.right, x + 1);
    box.bottom = std::max(box.bottom, y + 1);
  }
  return boxes;
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
    const Components fast = run(image);
    const Filled slow = flood_fill(image);
    EXPECT_EQ(component_of_each_pixel(fast), slow.of_pixel)
        << width << " x " << height << ", round " << round;
    EXPECT_EQ(fast.size, slow.size);
    EXPECT_EQ(fast.box, boxes_of(slow, width));
  }
}

TEST(Segment, BuffersOfALargerImageDoNotShowInASmallerOne) {
  SegmentScratch scratch;
  Components components;
  segment(Image(30, 30, kWhite), scratch, components);
  segment(ascii_image({"#.#"}), scratch, components);
  EXPECT_EQ(letters(components), (Rows{"abc"}));
  EXPECT_EQ(components.size, (std::vector<std::uint32_t>{1, 1, 1}));
}

}  // namespace
}  // namespace tagmint::detect
