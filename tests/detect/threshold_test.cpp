#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/s2_threshold.h"
#include "pipeline/stage_types.h"
#include "support/ascii_image.h"
#include "support/fixed_random.h"
#include "support/instruction_sets.h"

namespace tagmint::detect {
namespace {

using testing::ascii_rows;
using Rows = std::vector<std::string>;

Image run(ImageView working, int min_contrast = 5) {
  ThresholdScratch scratch;
  Image out;
  threshold(working, {min_contrast}, scratch, out);
  return out;
}

/// The definition: extrema over the 3x3 tiles about the pixel's own, looked up pixel by pixel.
Image naive(const Image& in, int min_contrast) {
  Image out(in.width(), in.height());
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < in.width(); ++x) {
      int low = 255, high = 0;
      for (int v = std::max(0, (y / 4 - 1) * 4); v < std::min(in.height(), (y / 4 + 2) * 4); ++v) {
        for (int u = std::max(0, (x / 4 - 1) * 4); u < std::min(in.width(), (x / 4 + 2) * 4); ++u) {
          low = std::min<int>(low, in.at(u, v));
          high = std::max<int>(high, in.at(u, v));
        }
      }
      out.at(x, y) = high - low < min_contrast      ? kUnknown
                     : 2 * in.at(x, y) > low + high ? kWhite
                                                    : kBlack;
    }
  }
  return out;
}

TEST(Threshold, AgreesWithTheDefinitionOnRandomPicturesOfAllSmallSizes) {
  testing::FixedRandom random(1);
  for (int width = 0; width <= 19; ++width) {
    for (int height = 0; height <= 14; ++height) {
      const int low = random.between(0, 250);
      const int high = random.between(low, std::min(255, low + (width % 2 ? 12 : 255)));
      Image image(width, height);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image.at(x, y) = std::uint8_t(random.between(low, high));
      }
      EXPECT_EQ(run(image, 10), naive(image, 10)) << width << " x " << height;
    }
  }
}

/// A picture whose neighbourhoods have contrasts on both sides of the floor.
Image random_picture(int width, int height, testing::FixedRandom& random) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int spread = x / 16 % 2 ? 9 : 60;
      image.at(x, y) = static_cast<std::uint8_t>(random.between(120 - spread, 120 + spread));
    }
  }
  return image;
}

TEST(Threshold, IsThePlainOneWithEveryInstructionSet) {
  testing::with_every_instruction_set([] {
    testing::FixedRandom random(6);
    for (const int width : {1, 3, 4, 15, 16, 17, 31, 33, 63, 64, 65, 66, 127, 129, 200}) {
      const int height = random.between(1, 13);
      const Image image = random_picture(width, height, random);
      for (const int min_contrast : {0, 5, 20, 255}) {
        ThresholdScratch scratch;
        Image plain;
        scalar::threshold(image, {min_contrast}, scratch, plain);
        EXPECT_EQ(run(image, min_contrast), plain) << width << " x " << height;
      }
    }
  });
}

TEST(Threshold, OfAViewWithAStrideReadsNothingElse) {
  testing::FixedRandom random(2);
  const Image whole = random_picture(150, 40, random);
  Image part(70, 21);
  for (int y = 0; y < 21; ++y) std::copy_n(whole.row(y + 7) + 33, 70, part.row(y));
  EXPECT_EQ(run({whole.row(7) + 33, 70, 21, 150}), run(part));
}

TEST(Threshold, PlainPicturesAreUnknown) {
  EXPECT_EQ(ascii_rows(run(Image(5, 2, 80))), (Rows{"?????", "?????"}));
}

TEST(Threshold, ContrastOneBelowTheFloorIsUnknown) {
  Image image(3, 1, 100);
  image.at(1, 0) = 104;
  EXPECT_EQ(ascii_rows(run(image, 5)), (Rows{"???"}));
  image.at(1, 0) = 105;
  EXPECT_EQ(ascii_rows(run(image, 5)), (Rows{"#.#"}));
}

TEST(Threshold, TheMiddleBetweenTheExtremaIsBlack) {
  Image image(3, 1, 0);
  image.at(1, 0) = 50;
  image.at(2, 0) = 100;
  EXPECT_EQ(ascii_rows(run(image)), (Rows{"##."}));
  image.at(1, 0) = 51;
  EXPECT_EQ(ascii_rows(run(image)), (Rows{"#.."}));
}

TEST(Threshold, AnEdgeIsKnownOnlyAsFarAsTheNeighbouringTiles) {
  Image image(20, 4, 200);
  for (int y = 0; y < 4; ++y) image.at(9, y) = 20;
  EXPECT_EQ(ascii_rows(run(image))[0], "????.....#......????");
}

TEST(Threshold, SlowShadingDoesNotHideATagInTheDark) {
  // Gray 20 on 60 at the left, 120 on 230 at the right: no single threshold parts both.
  Image image(64, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool black = x % 4 < 2;
      image.at(x, y) = std::uint8_t(black ? 20 + 100 * x / 63 : 60 + 170 * x / 63);
    }
  }
  std::string expected;
  for (int i = 0; i < 16; ++i) expected += "##..";
  EXPECT_EQ(ascii_rows(run(image))[2], expected);
}

TEST(Threshold, BuffersOfALargerImageDoNotShowInASmallerOne) {
  ThresholdScratch scratch;
  Image out;
  Image large(40, 40, 10);
  large.at(3, 3) = 200;
  threshold(large, {5}, scratch, out);
  Image small(6, 5, 90);
  small.at(5, 4) = 190;
  threshold(small, {5}, scratch, out);
  EXPECT_EQ(out, naive(small, 5));
}

}  // namespace
}  // namespace tagmint::detect
