#include "scene/effects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tagmint::scene {
namespace {

TEST(Noise, HasTheSigmaThatWasAskedForAndNoBias) {
  for (const double sigma : {1.0, 5.0, 20.0}) {
    const GrayPlane plane(640, 480, 128.3F);
    const detect::Image image = add_noise_and_round(plane, sigma, 7);
    double sum = 0;
    double squares = 0;
    for (int y = 0; y < 480; ++y) {
      for (int x = 0; x < 640; ++x) {
        const double deviation = image.at(x, y) - static_cast<double>(128.3F);
        sum += deviation;
        squares += deviation * deviation;
      }
    }
    const double n = 640.0 * 480;
    // The mean of n samples is sigma / 554 off; four times that is allowed. Rounding to whole
    // levels adds a variance of 1/12.
    EXPECT_NEAR(sum / n, 0, 4 * sigma / 554);
    EXPECT_NEAR(std::sqrt(squares / n - 1.0 / 12), sigma, 0.01 * sigma);
  }
}

TEST(Noise, OfNeighboursIsIndependent) {
  const GrayPlane plane(640, 480, 128.0F);
  const detect::Image image = add_noise_and_round(plane, 10, 3);
  double across = 0;
  double down = 0;
  for (int y = 1; y < 480; ++y) {
    for (int x = 1; x < 640; ++x) {
      across += (image.at(x, y) - 128.0) * (image.at(x - 1, y) - 128.0);
      down += (image.at(x, y) - 128.0) * (image.at(x, y - 1) - 128.0);
    }
  }
  // Correlations of 3e5 pairs scatter by 1 / 554.
  EXPECT_NEAR(across / (640 * 480 * 100.0), 0, 4.0 / 554);
  EXPECT_NEAR(down / (640 * 480 * 100.0), 0, 4.0 / 554);
}

TEST(Gamma, BrightensMiddleLightAndKeepsBlackAndWhite) {
  GrayPlane plane(4, 1);
  plane.levels = {0, 51, 255, 300};
  apply_gamma(2.2, plane);
  EXPECT_NEAR(plane.levels[0], 0, 1e-3);
  EXPECT_NEAR(plane.levels[1], 255 * std::pow(0.2, 1 / 2.2), 1e-2);
  EXPECT_NEAR(plane.levels[2], 255, 1e-3);
  EXPECT_NEAR(plane.levels[3], 255, 1e-3);
}

TEST(ShotNoise, HasThePoissonsMeanVarianceAndSkewness) {
  constexpr double kElectrons = 4;  // a gray level
  // Means of 1.2 to 800 electrons: counted one by one below 40, by the normal quantile above.
  for (const float level : {0.3F, 2.0F, 9.0F, 9.9F, 10.1F, 30.0F, 200.0F}) {
    GrayPlane plane(640, 480, level);
    apply_shot_noise(kElectrons, 7, plane);
    const double mean = level * kElectrons;
    double sum = 0, squares = 0, cubes = 0;
    for (const float found : plane.levels) {
      const double electrons = found * kElectrons;
      ASSERT_NEAR(electrons, std::round(electrons), 1e-3);  // whole ones
      sum += electrons - mean;
      squares += (electrons - mean) * (electrons - mean);
      cubes += std::pow(electrons - mean, 3);
    }
    const double n = 640.0 * 480;
    // Of n samples: the mean scatters by sigma / 554, the variance by 2.6e-3 and more where few
    // electrons come, the skewness by 0.0044.
    EXPECT_NEAR(sum / n, 0, 4 * std::sqrt(mean) / 554) << mean;
    EXPECT_NEAR(squares / n / mean, 1, 0.015) << mean;
    EXPECT_NEAR(cubes / n / std::pow(mean, 1.5), 1 / std::sqrt(mean), 0.03) << mean;
  }
}

TEST(ShotNoise, FollowsThePoissonDistribution) {
  // Shares of each count, at both sides of the change of method.
  for (const double mean : {3.0, 39.9, 40.1}) {
    GrayPlane plane(1000, 1000, static_cast<float>(mean));
    apply_shot_noise(1, 3, plane);
    std::vector<double> share(200);
    for (const float electrons : plane.levels) share[static_cast<std::size_t>(electrons)] += 1e-6;
    double found = 0, expected = 0, probability = std::exp(-mean);
    for (std::size_t k = 0; k < 100; ++k) {
      found += share[k];
      expected += probability;
      probability *= mean / static_cast<double>(k + 1);
      // A million samples scatter by 5e-4 where the distribution is a half.
      EXPECT_NEAR(found, expected, 3e-3) << mean << ", up to " << k;
    }
  }
}

TEST(ShotNoise, IsNoneInTheDarkAndWhereNotAskedFor) {
  GrayPlane dark(50, 50, 0.0F);
  apply_shot_noise(5, 1, dark);
  EXPECT_EQ(dark.levels, GrayPlane(50, 50, 0.0F).levels);
  GrayPlane plane(50, 50, 77.3F);
  apply_shot_noise(0, 1, plane);
  EXPECT_EQ(plane.levels, GrayPlane(50, 50, 77.3F).levels);
}

}  // namespace
}  // namespace tagmint::scene
