#include "numerics/normal_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "numerics/bilinear.h"
#include "support/fixed_random.h"
#include "support/paint_tags.h"

namespace tagmint::detect {
namespace {

/// Dark where x < edge, bright beyond, with the pixel on the edge shared by area; a pixel of the
/// blur exp(-x^2 / 2 sigma^2) when sigma is given.
Image step_at(double edge, double blur_px = 0) {
  testing::Canvas canvas(40, 20, 0);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 40; ++x) {
      canvas.at(x, y) = static_cast<float>(40 + 160 * std::clamp(x + 1 - edge, 0.0, 1.0));
    }
  }
  if (blur_px > 0) testing::blur(canvas, blur_px);
  testing::FixedRandom random(1);
  return testing::to_gray(canvas, 0, random);
}

TEST(NormalProfile, HoldsTheBilinearValuesAlongItsLine) {
  testing::FixedRandom random(4);
  Image image(31, 23);
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 31; ++x) image.at(x, y) = static_cast<std::uint8_t>(random.between(0, 255));
  }
  int read = 0;
  for (int round = 0; round < 500; ++round) {
    const Point foot{random.real(0, 31), random.real(0, 23)};
    const double turn = random.real(0, 2 * std::numbers::pi);
    const Point outward{std::cos(turn), std::sin(turn)};
    const double search = random.real(0.6, 4);
    const auto profile = read_profile(image, foot, outward, search, true);
    if (!profile) continue;
    ++read;
    EXPECT_GE(profile->reach * profile->step, search - 1e-6);
    for (int i = 0; i < profile->changes() + 2; ++i) {
      const Point at =
          foot + static_cast<double>((i - 1 - profile->reach) * profile->step) * outward;
      // Places count in 1/256 px, of steps of up to 255 levels in both directions.
      EXPECT_NEAR(profile->gray[static_cast<std::size_t>(i)], *sample_bilinear(image, at), 2.1);
    }
  }
  EXPECT_GT(read, 200);
}

TEST(NormalProfile, FindsAnEdgeWhereverItLiesBetweenPixels) {
  for (double edge = 15; edge < 16; edge += 0.1) {
    for (const double blur_px : {0.5, 0.8}) {
      const Image image = step_at(edge, blur_px);
      const auto profile = read_profile(image, {15.4, 10.2}, {1, 0}, 3, true);
      ASSERT_TRUE(profile);
      // Pixels of a sharp edge that lies along them show its phase: up to 0.07 px.
      EXPECT_NEAR(15.4 + mean_place_of_changes(*profile), edge, 0.08) << edge;
      const auto crossing = crossing_place(*profile, 120);
      ASSERT_TRUE(crossing);
      EXPECT_NEAR(15.4 + *crossing, edge, 0.08) << edge;
    }
  }
}

TEST(NormalProfile, TheMeanOverAllPhasesIsWithoutBias) {
  double sum = 0;
  int count = 0;
  for (double edge = 15; edge < 17; edge += 0.05) {
    const auto profile = read_profile(step_at(edge, 0.7), {15.7, 10}, {1, 0}, 3, true);
    ASSERT_TRUE(profile);
    sum += 15.7 + mean_place_of_changes(*profile) - edge;
    ++count;
  }
  EXPECT_NEAR(sum / count, 0, 0.004);
}

TEST(NormalProfile, TakesTheSenseThatWasAskedFor) {
  const Image image = step_at(15);
  EXPECT_TRUE(read_profile(image, {15, 10}, {1, 0}, 2, true));
  EXPECT_FALSE(read_profile(image, {15, 10}, {1, 0}, 2, false));
  EXPECT_FALSE(read_profile(image, {15, 10}, {-1, 0}, 2, true));
  EXPECT_TRUE(read_profile(image, {15, 10}, {-1, 0}, 2, false));
}

TEST(NormalProfile, IsNothingOnEvenGroundOrBeyondTheImage) {
  EXPECT_FALSE(read_profile(Image(40, 20, 90), {15, 10}, {1, 0}, 2, true));
  const Image image = step_at(15);
  EXPECT_FALSE(read_profile(image, {1, 10}, {1, 0}, 2, true));
  EXPECT_FALSE(read_profile(image, {15, 10}, {1, 0}, 30, true));
  EXPECT_FALSE(read_profile(image, {-500, 10}, {1, 0}, 2, true));
}

TEST(NormalProfile, AWideSearchTakesLargerStepsInstead) {
  const auto profile = read_profile(step_at(18), {15, 10}, {1, 0}, 12, true);
  ASSERT_TRUE(profile);
  EXPECT_LE(profile->reach, NormalProfile::kMaxReach);
  EXPECT_NEAR(mean_place_of_changes(*profile), 3, 0.2);
}

}  // namespace
}  // namespace tagmint::detect
