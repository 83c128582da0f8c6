#include <gtest/gtest.h>

#include <cmath>

#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tracker/t1_noise_floor.h"

namespace tagmint::detect {
namespace {

Image even_with_noise(double sigma) {
  testing::FixedRandom random(12);
  return testing::to_gray(testing::Canvas(640, 480, 128), sigma, random);
}

TEST(NoiseFloor, BothEstimatesFindTheNoiseOfAnEvenPicture) {
  for (const double sigma : {2.0, 5.0, 12.0, 25.0}) {
    const Image image = even_with_noise(sigma);
    EXPECT_NEAR(estimate_noise(image), sigma, 0.12 * sigma);
    EXPECT_NEAR(estimate_calm_noise(image), sigma, 0.12 * sigma);
  }
}

TEST(NoiseFloor, TextureOverMostOfThePictureIsNotCalmNoise) {
  // Strong noise over nine tenths of the picture stands for grass; the rest is smooth paper.
  testing::FixedRandom random(5);
  Image image = even_with_noise(2);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 576; ++x) {
      image.at(x, y) =
          static_cast<std::uint8_t>(std::clamp(128 + 30 * random.normal(), 1.0, 254.0));
    }
  }
  EXPECT_GT(estimate_noise(image), 20);
  EXPECT_LT(estimate_calm_noise(image), 4);
}

TEST(NoiseFloor, PicturesTooNarrowToJudgeHaveNone) {
  EXPECT_EQ(estimate_noise(Image(20, 20, 7)), 0);
  EXPECT_EQ(estimate_calm_noise(Image(20, 20, 7)), 0);
  EXPECT_EQ(estimate_calm_noise(Image(1, 1)), 0);
}

TEST(NoiseFloor, KeepsToItsBounds) {
  EXPECT_EQ(contrast_floor(0, 5, 36), 5);
  EXPECT_EQ(contrast_floor(2, 5, 36), 17);
  EXPECT_EQ(contrast_floor(50, 5, 36), 36);
}

}  // namespace
}  // namespace tagmint::detect
