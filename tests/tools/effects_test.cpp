#include "scene/effects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

/// Mean place and second moments about it of what a bright point becomes.
struct Spot {
  double mass = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

Spot moved_point(const MotionBlur& motion) {
  GrayPlane plane(81, 81);
  plane.row(40)[40] = 1;
  apply_motion_blur(motion, plane);
  Spot spot;
  for (int y = 0; y < 81; ++y) {
    for (int x = 0; x < 81; ++x) {
      const double level = plane.row(y)[x];
      spot.mass += level;
      spot.x += level * (x - 40);
      spot.y += level * (y - 40);
      spot.xx += level * (x - 40) * (x - 40);
      spot.xy += level * (x - 40) * (y - 40);
      spot.yy += level * (y - 40) * (y - 40);
    }
  }
  return spot;
}

TEST(MotionBlur, SpreadsAPointEvenlyOverItsLengthAndStaysInPlace) {
  for (const double angle : {0.0, 30.0, 90.0, 135.0}) {
    for (const double length : {3.0, 8.0, 20.5}) {
      const Spot spot = moved_point({.length_px = length, .angle_deg = angle});
      const double c = std::cos(angle * std::numbers::pi / 180);
      const double s = std::sin(angle * std::numbers::pi / 180);
      EXPECT_NEAR(spot.mass, 1, 1e-5);
      EXPECT_NEAR(spot.x, 0, 1e-4);
      EXPECT_NEAR(spot.y, 0, 1e-4);
      const double along = c * c * spot.xx + 2 * c * s * spot.xy + s * s * spot.yy;
      const double across = s * s * spot.xx - 2 * c * s * spot.xy + c * c * spot.yy;
      // A line's variance is length^2 / 12; sharing between pixels adds a quarter at most.
      EXPECT_GE(along, length * length / 12 - 0.01) << angle << ' ' << length;
      EXPECT_LE(along, length * length / 12 + 0.26) << angle << ' ' << length;
      EXPECT_LE(across, 0.26) << angle << ' ' << length;
    }
  }
}

TEST(MotionBlur, LeavesAnEvenPictureAlone) {
  GrayPlane plane(30, 7, 93.0F);
  apply_motion_blur({.length_px = 12, .angle_deg = 40}, plane);
  for (const float level : plane.levels) EXPECT_NEAR(level, 93, 1e-3);
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
