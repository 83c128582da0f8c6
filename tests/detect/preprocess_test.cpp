#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "pipeline/s1_preprocess.h"
#include "support/fixed_random.h"
#include "support/polygon_image.h"

namespace tagmint::detect {
namespace {

Image random_image(int width, int height, std::uint64_t seed) {
  testing::FixedRandom random(seed);
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = std::uint8_t(random.between(0, 255));
  }
  return image;
}

/// The options applied with buffers of their own; the result copied.
Image run(ImageView full, const PreprocessOptions& options) {
  PreprocessScratch scratch;
  Image working;
  const ImageView view = preprocess(full, options, scratch, working);
  Image copy(view.width, view.height);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) copy.at(x, y) = view.at(x, y);
  }
  return copy;
}

TEST(Preprocess, TheImageItselfGoesOnWhenThereIsNothingToDo) {
  const Image image = random_image(7, 5, 1);
  PreprocessScratch scratch;
  Image working;
  const ImageView view = preprocess(image, {1.0, 0.0}, scratch, working);
  EXPECT_EQ(view.data, image.view().data);
  EXPECT_EQ(view.width, 7);
}

TEST(Preprocess, DecimationByTwoIsTheMeanOfFourPixels) {
  Image image(4, 2);
  const std::uint8_t values[2][4] = {{10, 20, 200, 201}, {30, 40, 202, 203}};
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) image.at(x, y) = values[y][x];
  }
  const Image half = run(image, {2.0, 0.0});
  ASSERT_EQ(half.width(), 2);
  ASSERT_EQ(half.height(), 1);
  EXPECT_EQ(half.at(0, 0), 25);
  EXPECT_EQ(half.at(1, 0), 202);  // 201.5, rounded up
}

TEST(Preprocess, DecimationByOneAndAHalfWeightsPixelsByTheirShare) {
  Image image(3, 3);
  std::uint8_t value = 0;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) image.at(x, y) = value += 25;  // 25 .. 225
  }
  const Image small = run(image, {1.5, 0.0});
  ASSERT_EQ(small.width(), 2);
  // (25 + 50 / 2 + 100 / 2 + 125 / 4) / 2.25
  EXPECT_EQ(small.at(0, 0), 58);
  EXPECT_EQ(small.at(1, 1), 192);
}

TEST(Preprocess, SizesAreRoundedDown) {
  EXPECT_EQ(run(random_image(11, 7, 1), {2.0, 0.0}).width(), 5);
  EXPECT_EQ(run(random_image(11, 7, 1), {2.0, 0.0}).height(), 3);
  EXPECT_EQ(run(random_image(11, 7, 1), {1.5, 0.0}).width(), 7);
  EXPECT_EQ(run(random_image(11, 7, 1), {2.75, 0.0}).width(), 4);
  EXPECT_TRUE(run(random_image(11, 7, 1), {8.0, 0.0}).view().empty());
  EXPECT_TRUE(run(random_image(11, 7, 1), {1e30, 0.0}).view().empty());
}

/// The definition of decimation, pixel by pixel.
double mean_over_square(const Image& image, double left, double top, double side) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double dx = std::min(x + 1.0, left + side) - std::max<double>(x, left);
      const double dy = std::min(y + 1.0, top + side) - std::max<double>(y, top);
      if (dx > 0 && dy > 0) sum += dx * dy * image.at(x, y);
    }
  }
  return sum / (side * side);
}

TEST(Preprocess, AWorkingPixelIsTheMeanOfItsSquareForAnyFactor) {
  for (double factor : {1.1, 1.5, 2.0, 2.5, 3.0, 4.0, 5.3}) {
    const Image image = random_image(23, 17, 5);
    const Image small = run(image, {factor, 0.0});
    for (int y = 0; y < small.height(); ++y) {
      for (int x = 0; x < small.width(); ++x) {
        EXPECT_NEAR(small.at(x, y), mean_over_square(image, x * factor, y * factor, factor), 0.51)
            << "factor " << factor << " at " << x << ", " << y;
      }
    }
  }
}

TEST(Preprocess, AFactorOfOneButForRoundingLeavesTheImageAsItIs) {
  const Image image = random_image(9, 7, 3);
  EXPECT_EQ(run(image, {1 + 1e-12, 0.0}), image);
  EXPECT_EQ(run(image, {2 + 1e-12, 0.0}), run(image, {2.0, 0.0}));
}

TEST(Preprocess, TheScaleMapsTheCentroidOfASpotExactly) {
  // From 30 to 60 across and from 60 to 90 down: on edges of working pixels for every factor here.
  Image image(120, 120, 0);
  testing::paint_polygon(image, testing::square_corners({45, 75}, 30), 250);
  for (double factor : {1.0, 1.5, 2.0, 2.5, 3.0, 5.0}) {
    const Image small = run(image, {factor, 0.0});
    double sum = 0;
    Point centroid;
    for (int y = 0; y < small.height(); ++y) {
      for (int x = 0; x < small.width(); ++x) {
        sum += small.at(x, y);
        centroid = centroid + small.at(x, y) * Point{x + 0.5, y + 0.5};
      }
    }
    centroid = (1 / sum) * centroid;
    const WorkingScale scale{factor};
    EXPECT_NEAR(scale.to_full(centroid).x, 45, 1e-9) << factor;
    EXPECT_NEAR(scale.to_full(centroid).y, 75, 1e-9) << factor;
    EXPECT_NEAR(scale.to_working(scale.to_full(centroid)).x, centroid.x, 1e-12);
    EXPECT_NEAR(scale.to_working(scale.to_full(centroid)).y, centroid.y, 1e-12);
  }
}

TEST(Preprocess, BlurKeepsAPlainImageAsItIs) {
  for (int gray : {0, 1, 100, 254, 255}) {
    const Image plain(9, 6, std::uint8_t(gray));
    EXPECT_EQ(run(plain, {1.0, 0.8}), plain) << gray;
    EXPECT_EQ(run(plain, {1.0, 5.0}), plain) << gray;
    EXPECT_EQ(run(plain, {1.0, -1.5}), plain) << gray;
  }
}

TEST(Preprocess, ABlurFarBelowAPixelKeepsTheImage) {
  const Image image = random_image(12, 9, 3);
  EXPECT_EQ(run(image, {1.0, 1e-200}), image);
  EXPECT_EQ(run(image, {1.0, -1e-200}), image);
}

TEST(Preprocess, BlurOfAnEdgeFollowsTheNormalDistribution) {
  Image image(41, 3, 0);
  for (int y = 0; y < 3; ++y) {
    for (int x = 20; x < 41; ++x) image.at(x, y) = 200;
  }
  const double sigma = 2.0;
  const Image blurred = run(image, {1.0, sigma});
  for (int x = 0; x < 41; ++x) {
    const double expected = 100 * (1 + std::erf((x + 0.5 - 20) / (sigma * std::sqrt(2.0))));
    // The kernel is sampled and cut off at 3 sigma: below half a percent of the step.
    EXPECT_NEAR(blurred.at(x, 1), expected, 1.5) << x;
  }
}

TEST(Preprocess, SharpeningSteepensAnEdgeByAsMuchAsBlurringFlattensIt) {
  Image image(20, 1, 100);
  for (int x = 10; x < 20; ++x) image.at(x, 0) = 150;
  const Image blurred = run(image, {1.0, 1.0});
  const Image sharpened = run(image, {1.0, -1.0});
  for (int x = 0; x < 20; ++x) {
    EXPECT_EQ(sharpened.at(x, 0) - image.at(x, 0), image.at(x, 0) - blurred.at(x, 0));
  }
  EXPECT_LT(sharpened.at(9, 0), 95);
}

TEST(Preprocess, RowsMayLieInAnyOrderAndAtAnyDistance) {
  const Image image = random_image(10, 6, 9);
  const ImageView upside_down{image.row(5), 10, 6, -10};
  const Image small = run(upside_down, {2.0, 0.0});
  EXPECT_EQ(small.at(0, 0),
            (image.at(0, 5) + image.at(1, 5) + image.at(0, 4) + image.at(1, 4) + 2) / 4);
  const ImageView narrow{image.row(0), 4, 6, 10};
  EXPECT_EQ(run(narrow, {2.0, 1.0}).width(), 2);
}

TEST(Preprocess, EverySmallSizePasses) {
  for (int width = 0; width < 6; ++width) {
    for (int height = 0; height < 6; ++height) {
      const Image image = random_image(width, height, 2);
      for (double factor : {1.0, 1.5, 2.0, 3.0}) {
        for (double sigma : {0.0, 0.8, 4.0, -0.8}) {
          EXPECT_EQ(run(image, {factor, sigma}).width(), int(width / factor));
        }
      }
    }
  }
}

TEST(Preprocess, ImpossibleOptionsAreRefused) {
  const Image image(4, 4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run(image, {0.5, 0.0}), std::invalid_argument);
  EXPECT_THROW(run(image, {nan, 0.0}), std::invalid_argument);
  EXPECT_THROW(run(image, {1.0, nan}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::detect
