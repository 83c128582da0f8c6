#include "scene/effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/background.h"

namespace tagmint::scene {
namespace {

TEST(GaussianWeights, HaveTheVarianceThatWasAskedFor) {
  for (const double sigma : {0.05, 0.3, 0.5, 1.0, 2.5, 7.0, 40.0}) {
    const std::vector<double> weights = gaussian_weights(sigma);
    double sum = weights[0];
    double variance = 0;
    for (std::size_t k = 1; k < weights.size(); ++k) {
      sum += 2 * weights[k];
      variance += 2 * weights[k] * static_cast<double>(k * k);
    }
    EXPECT_NEAR(sum, 1, 1e-9) << sigma;
    EXPECT_NEAR(variance / (sigma * sigma), 1, 1e-6) << sigma;
  }
}

TEST(Blur, SpreadsAnEdgeByItsSigmaInBothDirections) {
  for (const double sigma : {0.4, 1.0, 2.5}) {
    for (const bool across : {true, false}) {
      GrayPlane plane(64, 64);
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) plane.row(y)[x] = (across ? x : y) < 32 ? 200 : 50;
      }
      apply_blur(sigma, plane);
      // The edge's derivative is the kernel: its second moment is the variance.
      double mass = 0;
      double moment = 0;
      for (int i = 1; i < 64; ++i) {
        const double step = across ? plane.row(30)[i - 1] - plane.row(30)[i]
                                   : plane.row(i - 1)[30] - plane.row(i)[30];
        mass += step;
        moment += step * (i - 32) * (i - 32);
      }
      EXPECT_NEAR(mass, 150, 1e-3);
      EXPECT_NEAR(std::sqrt(moment / mass), sigma, 0.002 * sigma);
    }
  }
}

TEST(Blur, LeavesAnEvenPictureAlone) {
  GrayPlane plane(7, 3, 93.0F);
  apply_blur(4, plane);
  for (const float level : plane.levels) EXPECT_NEAR(level, 93, 1e-3);
}

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

TEST(Shading, RunsFromFullLightToOneLessStrength) {
  GrayPlane plane(101, 51, 200.0F);
  apply_shading({.strength = 0.4, .angle_deg = 0}, plane);
  EXPECT_NEAR(plane.row(20)[0], 200 * (1 - 0.4 * 0.5 / 101), 1e-3);
  EXPECT_NEAR(plane.row(20)[50], 160, 1e-3);
  EXPECT_NEAR(plane.row(20)[100], 200 * (1 - 0.4 * 100.5 / 101), 1e-3);
  GrayPlane down(101, 51, 200.0F);
  apply_shading({.strength = 0.4, .angle_deg = 90}, down);
  EXPECT_NEAR(down.row(0)[7], 200 * (1 - 0.4 * 0.5 / 51), 1e-3);
  EXPECT_NEAR(down.row(25)[7], 160, 1e-3);
}

TEST(Background, GradientMeetsItsEnds) {
  const GrayPlane plane =
      draw_background(GradientBackground{.from = 50, .to = 150, .angle_deg = 180}, 100, 10, 1);
  EXPECT_NEAR(plane.row(3)[0], 149.5, 1e-3);
  EXPECT_NEAR(plane.row(3)[99], 50.5, 1e-3);
}

TEST(Background, TextureStaysWithinItsAmplitudeAndFollowsTheSeed) {
  const TextureBackground texture{.gray = 120, .amplitude = 30, .scale_px = 16};
  const GrayPlane first = draw_background(texture, 160, 120, 1);
  EXPECT_EQ(first.levels, draw_background(texture, 160, 120, 1).levels);
  EXPECT_NE(first.levels, draw_background(texture, 160, 120, 2).levels);
  float lowest = 255;
  float highest = 0;
  for (const float level : first.levels) {
    lowest = std::min(lowest, level);
    highest = std::max(highest, level);
  }
  EXPECT_GE(lowest, 90);
  EXPECT_LE(highest, 150);
  EXPECT_GT(highest - lowest, 20);
}

TEST(Background, PhotographOfTheSameSizeIsKeptPixelByPixel) {
  PhotoBackground photo;
  photo.image = detect::Image(9, 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) photo.image.at(x, y) = static_cast<std::uint8_t>(x * 20 + y);
  }
  const GrayPlane plane = draw_background(photo, 9, 7, 1);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) EXPECT_NEAR(plane.row(y)[x], photo.image.at(x, y), 1e-3);
  }
}

TEST(Background, PhotographIsScaledToCoverAndCutEvenly) {
  // Three upright stripes; a square cut from the middle of a picture twice as wide as high.
  PhotoBackground photo;
  photo.image = detect::Image(80, 40, 10);
  for (int y = 0; y < 40; ++y) {
    for (int x = 20; x < 60; ++x) photo.image.at(x, y) = 210;
  }
  const GrayPlane plane = draw_background(photo, 20, 20, 1);
  for (int x = 1; x < 19; ++x) EXPECT_NEAR(plane.row(10)[x], 210, 1e-3) << x;
}

}  // namespace
}  // namespace tagmint::scene
