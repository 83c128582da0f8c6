// Gray levels across straight edges, beside what integrals say of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "scene/projection.h"
#include "scene/render.h"
#include "support/test_families.h"

namespace tagmint::scene {
namespace {

using detect::Corners;
using detect::Point;

constexpr double kBlack = 30;
constexpr double kWhite = 220;

/// The second integral of a Gaussian's distribution function; of a step where sigma is 0.
double twice_integrated(double t, double sigma) {
  if (sigma == 0) return t > 0 ? t * t / 2 : 0;
  const double density = std::exp(-t * t / (2 * sigma * sigma)) / std::sqrt(2 * std::numbers::pi);
  const double share = std::erfc(-t / (sigma * std::numbers::sqrt2)) / 2;
  return ((t * t + sigma * sigma) * share + t * sigma * density) / 2;
}

/// A step at 0 seen through a Gaussian and boxes of full widths a and b, at t.
double through_boxes(double t, double sigma, double a, double b) {
  // A box of no width divides by it.
  a = std::max(a, 1e-4) / 2;
  b = std::max(b, 1e-4) / 2;
  return (twice_integrated(t + a + b, sigma) - twice_integrated(t + a - b, sigma) -
          twice_integrated(t - a + b, sigma) + twice_integrated(t - a - b, sigma)) /
         (4 * a * b);
}

/// The mean of f over an interval of full width w about t.
double mean_over(const std::function<double(double)>& f, double t, double w) {
  constexpr int kPoints = 50;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) sum += f(t + w * ((i + 0.5) / kPoints - 0.5));
  return sum / kPoints;
}

struct Deviation {
  double most = 0;
  double mean = 0;
  int pixels = 0;
};

/// How far the picture is off across the left edge of a tag that is turned by `angle_deg`; its
/// outer and inner sides are 25 px of white and of black.
///   share   of black, a function of the pixel's distance beyond the edge, px
Deviation deviation(const Effects& effects, double angle_deg, double reach_px,
                    const std::function<double(double)>& share) {
  Scene scene;
  scene.width = scene.height = 400;
  scene.camera = default_camera(400, 400);
  scene.background = PlainBackground{kWhite};
  scene.effects = effects;
  const double a = angle_deg * std::numbers::pi / 180;
  const Point right{std::cos(a), std::sin(a)}, down{-right.y, right.x};
  const Point centre{201.37, 198.81};
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = 100 * detect::kTagCorners[i];
    corners[i] = centre + p.x * right + p.y * down;
  }
  scene.tags = {{test::arbitrary_family("classic:10"), 3, corners}};
  const detect::Image image = render(scene).image;
  Deviation found;
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) {
      const Point p = Point{x + 0.5, y + 0.5} - centre;
      const double beyond = dot(p, right) + 100;
      if (std::abs(beyond) > reach_px || std::abs(dot(p, down)) > 60) continue;
      const double off = image.at(x, y) - (kWhite - (kWhite - kBlack) * share(beyond));
      found.most = std::max(found.most, std::abs(off));
      found.mean += off;
      ++found.pixels;
    }
  }
  found.mean /= found.pixels;
  return found;
}

constexpr std::array<double, 6> kAngles = {0, 3, 17, 45, -31, 90};

// Rounding is off by half a level, the grid's straight pieces by 0.2 % of the contrast of 190.
constexpr double kMostOff = 0.5 + 0.4;
// Along an upright edge all rows are rounded alike, so the mean is that of a dozen roundings.
constexpr double kMostMean = 0.2;

TEST(EdgeProfile, OfASharpEdgeIsThePixelsArea) {
  for (const double angle : kAngles) {
    const double c = std::abs(std::cos(angle * std::numbers::pi / 180));
    const double s = std::abs(std::sin(angle * std::numbers::pi / 180));
    const Deviation found =
        deviation({}, angle, 12, [&](double t) { return through_boxes(t, 0, c, s); });
    EXPECT_GT(found.pixels, 2500);
    EXPECT_LE(found.most, 0.51) << angle;  // rounding
    EXPECT_NEAR(found.mean, 0, 0.05) << angle;
  }
}

TEST(EdgeProfile, OfABlurredEdgeIsTheIntegralOfAGaussian) {
  for (const double sigma : {0.2, 0.35, 0.5, 0.7, 1.0, 1.5, 2.0, 2.9, 3.0, 4.0}) {
    for (const double angle : kAngles) {
      const double c = std::abs(std::cos(angle * std::numbers::pi / 180));
      const double s = std::abs(std::sin(angle * std::numbers::pi / 180));
      const Deviation found = deviation({.blur_sigma_px = sigma}, angle, 8, [&](double t) {
        // The white ring's outer side and the black one's inner side are 25 px away.
        return through_boxes(t, sigma, c, s);
      });
      EXPECT_LE(found.most, kMostOff) << sigma << " px, " << angle << " degrees";
      EXPECT_NEAR(found.mean, 0, kMostMean) << sigma << " px, " << angle << " degrees";
    }
  }
}

TEST(EdgeProfile, OfAMovedEdgeIsTheIntegralOfItsWay) {
  for (const double length : {1.0, 4.0, 9.0}) {
    for (const double sigma : {0.0, 0.6}) {
      const Effects effects{.motion_blur = {.length_px = length, .angle_deg = 0},
                            .blur_sigma_px = sigma};
      // Across the edge a box as long as the way; the pixel is another one.
      const Deviation across =
          deviation(effects, 0, 10, [&](double t) { return through_boxes(t, sigma, 1, length); });
      EXPECT_LE(across.most, kMostOff) << length << " px, blur " << sigma;
      EXPECT_NEAR(across.mean, 0, kMostMean) << length << " px, blur " << sigma;
      // Along the edge nothing.
      const Deviation along =
          deviation(effects, 90, 10, [&](double t) { return through_boxes(t, sigma, 1, 0); });
      EXPECT_LE(along.most, kMostOff) << length << " px, blur " << sigma;
    }
  }
}

TEST(EdgeProfile, OfAnEdgeOutOfFocusIsTheIntegralOfADisc) {
  for (const double radius : {0.6, 1.0, 2.5, 6.0}) {
    const auto disc = [&](double t) {
      const double u = std::clamp(t / radius, -1.0, 1.0);
      return 0.5 + (u * std::sqrt(1 - u * u) + std::asin(u)) / std::numbers::pi;
    };
    for (const double angle : kAngles) {
      const double c = std::abs(std::cos(angle * std::numbers::pi / 180));
      const double s = std::abs(std::sin(angle * std::numbers::pi / 180));
      const auto across = [&](double t) { return mean_over(disc, t, c); };
      const Deviation found = deviation({.defocus_px = radius}, angle, 8, [&](double t) {
        return s < 1e-9 ? across(t) : mean_over(across, t, s);
      });
      EXPECT_LE(found.most, kMostOff + 0.3) << radius << " px, " << angle << " degrees";
      EXPECT_NEAR(found.mean, 0, kMostMean) << radius << " px, " << angle << " degrees";
    }
  }
}

TEST(EdgeProfile, ThroughALensFollowsTheCurve) {
  Scene scene;
  scene.width = 640;
  scene.height = 480;
  scene.camera = default_camera(640, 480);
  scene.camera.k1 = -0.25;
  scene.camera.k2 = 0.05;
  scene.camera.p1 = 0.002;
  scene.background = PlainBackground{kWhite};
  PosedTag posed;
  posed.pose.t = {0.01, -0.02, 0.3};
  posed.edge_m = 0.16;
  scene.tags = {{test::arbitrary_family("classic:10"), 3, posed}};
  const TagProjection projection(scene.tags[0].place, scene.camera);
  for (const double sigma : {0.0, 0.5, 1.2}) {
    scene.effects.blur_sigma_px = sigma;
    const detect::Image image = render(scene).image;
    double most = 0;
    int pixels = 0;
    for (int i = -80; i <= 80; ++i) {
      // About the upper edge: pixels of the column, by their distance from the curve's tangent.
      const Point edge = projection.project({i / 100.0, -1});
      const int x = static_cast<int>(edge.x);
      const Point next = projection.project({i / 100.0 + 1e-4, -1});
      const Point along = 1 / length(next - edge) * (next - edge);
      for (int y = static_cast<int>(edge.y) - 6; y <= static_cast<int>(edge.y) + 6; ++y) {
        const double beyond = cross(along, Point{x + 0.5, y + 0.5} - edge);
        const double share = through_boxes(beyond, sigma, std::abs(along.x), std::abs(along.y));
        most = std::max(most, std::abs(image.at(x, y) - kWhite + (kWhite - kBlack) * share));
        ++pixels;
      }
    }
    EXPECT_GT(pixels, 2000);
    // A pixel's column is up to a pixel from where the tangent touches: 0.001 px of the curve.
    EXPECT_LE(most, kMostOff + 0.2) << sigma;
  }
}

}  // namespace
}  // namespace tagmint::scene
