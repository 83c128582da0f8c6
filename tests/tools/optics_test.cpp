#include "scene/optics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/fill.h"
#include "scene/gaussian.h"

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
    EXPECT_NEAR(variance / (sigma * sigma), 1, 1e-3) << sigma;
  }
}

TEST(WideBlur, SpreadsAnEdgeByItsSigmaInBothDirections) {
  for (const double sigma : {1.0, 2.5, 4.0}) {
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

TEST(WideBlur, LeavesAnEvenPictureAlone) {
  GrayPlane plane(7, 3, 93.0F);
  apply_blur(4, plane);
  for (const float level : plane.levels) EXPECT_NEAR(level, 93, 1e-3);
}

/// Mass, mean place and second moments about its true place of what a point becomes.
struct Spot {
  double mass = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// What `effects` make of a point of light as large as a pixel, its middle at `centre`.
GrayPlane exposed_point(const Effects& effects, detect::Point centre) {
  const PointSpread point_spread(effects);
  const int scale = point_spread.scale();
  const Window window{
      .width = 81, .height = 81, .scale = scale, .first_row = 0, .rows = 81 * scale};
  GrayPlane light(window.columns(), window.rows);
  const double left = centre.x - 0.5, top = centre.y - 0.5;
  const Patch point{{{left, top}, {left + 1, top}, {left + 1, top + 1}, {left, top + 1}}, 1};
  paint({&point, 1}, window, light);
  GrayPlane picture(81, 81);
  PointSpread::Scratch scratch;
  point_spread.expose(light, window, 0, 81, picture, scratch);
  return picture;
}

/// The mean over points everywhere on a pixel and on the samples of the grid.
Spot spot_of(const Effects& effects) {
  constexpr int kPlaces = 16;
  Spot spot;
  for (int i = 0; i < kPlaces; ++i) {
    const detect::Point centre{40 + (i + 0.5) / kPlaces, 40 + (i * 5 % kPlaces + 0.5) / kPlaces};
    const GrayPlane plane = exposed_point(effects, centre);
    for (int y = 0; y < 81; ++y) {
      for (int x = 0; x < 81; ++x) {
        const double level = plane.row(y)[x] / kPlaces;
        const double dx = x + 0.5 - centre.x, dy = y + 0.5 - centre.y;
        spot.mass += level;
        spot.x += level * dx;
        spot.y += level * dy;
        spot.xx += level * dx * dx;
        spot.xy += level * dx * dy;
        spot.yy += level * dy * dy;
      }
    }
  }
  return spot;
}

/// A pixel-sized point seen by pixels is a tent: variance 1/6.
constexpr double kOfPixels = 1.0 / 6;

TEST(PointSpread, OfAGaussianHasItsVarianceHoweverNarrow) {
  for (const double sigma : {0.0, 0.1, 0.3, 0.5, 0.7, 1.0, 2.0, 2.9}) {
    const Spot spot = spot_of({.blur_sigma_px = sigma});
    EXPECT_NEAR(spot.mass, 1, 1e-5) << sigma;
    EXPECT_NEAR(spot.x, 0, 1e-4) << sigma;
    EXPECT_NEAR(spot.y, 0, 1e-4) << sigma;
    EXPECT_NEAR(spot.xx, sigma * sigma + kOfPixels, 2e-3 * (1 + sigma * sigma)) << sigma;
    EXPECT_NEAR(spot.yy, sigma * sigma + kOfPixels, 2e-3 * (1 + sigma * sigma)) << sigma;
    EXPECT_NEAR(spot.xy, 0, 1e-4) << sigma;
  }
}

TEST(PointSpread, OfDefocusIsADiscOfItsRadius) {
  for (const double radius : {0.5, 1.0, 3.0, 9.5}) {
    const Effects effects{.defocus_px = radius};
    const Spot spot = spot_of(effects);
    EXPECT_NEAR(spot.mass, 1, 1e-5) << radius;
    // A disc's variance along a line is r^2 / 4.
    const double variance = radius * radius / 4 + kOfPixels;
    EXPECT_NEAR(spot.xx, variance, 0.01 * variance) << radius;
    EXPECT_NEAR(spot.yy, variance, 0.01 * variance) << radius;
    EXPECT_NEAR(spot.xy, 0, 1e-4) << radius;
  }
  // Even inside, nothing outside.
  const GrayPlane disc = exposed_point({.defocus_px = 9}, {40.5, 40.5});
  for (int y = 0; y < 81; ++y) {
    for (int x = 0; x < 81; ++x) {
      const double r = std::hypot(x - 40, y - 40);
      if (r < 7) {
        EXPECT_NEAR(disc.row(y)[x] * std::numbers::pi * 81, 1, 0.01);
      } else if (r > 11) {
        EXPECT_EQ(disc.row(y)[x], 0);
      }
    }
  }
}

TEST(PointSpread, OfMotionIsALineOfItsLengthInItsPlace) {
  for (const double angle : {0.0, 30.0, 90.0, 135.0}) {
    for (const double length : {0.5, 3.0, 8.0, 20.5}) {
      const Spot spot = spot_of({.motion_blur = {.length_px = length, .angle_deg = angle}});
      const double c = std::cos(angle * std::numbers::pi / 180);
      const double s = std::sin(angle * std::numbers::pi / 180);
      EXPECT_NEAR(spot.mass, 1, 1e-5);
      EXPECT_NEAR(spot.x, 0, 1e-4);
      EXPECT_NEAR(spot.y, 0, 1e-4);
      const double along = c * c * spot.xx + 2 * c * s * spot.xy + s * s * spot.yy - kOfPixels;
      const double across = s * s * spot.xx - 2 * c * s * spot.xy + c * c * spot.yy - kOfPixels;
      // A line's variance is length^2 / 12; sharing between the samples of a grid of at least three
      // a pixel adds up to 1 / 36.
      EXPECT_GE(along, length * length / 12 - 0.003) << angle << ' ' << length;
      EXPECT_LE(along, length * length / 12 + 0.03) << angle << ' ' << length;
      EXPECT_GE(across, -0.001) << angle << ' ' << length;
      EXPECT_LE(across, 0.03) << angle << ' ' << length;
    }
  }
}

TEST(PointSpread, OfSeveralEffectsHasTheSumOfTheirVariances) {
  const Effects all{
      .motion_blur = {.length_px = 6, .angle_deg = 0}, .defocus_px = 2, .blur_sigma_px = 0.8};
  const Spot spot = spot_of(all);
  const double round = 0.8 * 0.8 + 2.0 * 2 / 4 + kOfPixels;
  EXPECT_NEAR(spot.mass, 1, 1e-5);
  EXPECT_NEAR(spot.xx, round + 6.0 * 6 / 12, 0.06);
  EXPECT_NEAR(spot.yy, round, 0.03);
}

TEST(PointSpread, LeavesAnEvenPictureAloneUpToItsEdges) {
  for (const Effects& effects :
       {Effects{}, Effects{.blur_sigma_px = 1.3}, Effects{.defocus_px = 4},
        Effects{.motion_blur = {.length_px = 12, .angle_deg = 40}, .blur_sigma_px = 0.5}}) {
    const PointSpread point_spread(effects);
    const int scale = point_spread.scale();
    const Window window{
        .width = 30, .height = 7, .scale = scale, .first_row = 0, .rows = 7 * scale};
    const GrayPlane light(window.columns(), window.rows, 93.0F);
    GrayPlane picture(30, 7);
    PointSpread::Scratch scratch;
    point_spread.expose(light, window, 0, 7, picture, scratch);
    for (const float level : picture.levels) EXPECT_NEAR(level, 93, 1e-3);
  }
}

}  // namespace
}  // namespace tagmint::scene
