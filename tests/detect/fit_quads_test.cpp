#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "pipeline/s5_fit_quads.h"
#include "support/ascii_image.h"
#include "support/fixed_random.h"
#include "support/front_half.h"
#include "support/polygon_image.h"

namespace tagmint::detect {
namespace {

using testing::FrontHalf;
using testing::paint_polygon;
using testing::square_corners;

constexpr std::uint8_t kPaper = 230;
constexpr double kInk = 20;

Image picture_of(const Corners& corners, int side = 100) {
  Image image(side, side, kPaper);
  paint_polygon(image, corners, kInk);
  return image;
}

/// Offset of the corner of `quad` that is nearest to `truth` from it.
Point nearest_offset(const Quad& quad, Point truth) {
  Point best{1e9, 1e9};
  for (const Point corner : quad.corners) {
    if (length(corner - truth) < length(best)) best = corner - truth;
  }
  return best;
}

double worst_offset(const Quad& quad, const Corners& truth) {
  double worst = 0;
  for (const Point p : truth) worst = std::max(worst, length(nearest_offset(quad, p)));
  return worst;
}

TEST(FitQuads, AnUprightSquareOnPixelEdgesIsFoundExactly) {
  FrontHalf front;
  for (int side : {8, 9, 15, 24, 60}) {
    const Corners truth = square_corners({50 + side % 2 / 2.0, 50 + side % 2 / 2.0}, side);
    const auto quads = front.quads(picture_of(truth));
    ASSERT_EQ(quads.size(), 1u) << side;
    EXPECT_LT(worst_offset(quads[0], truth), 0.05) << side;
  }
}

TEST(FitQuads, TurnedSquaresAreFoundWithinAThirdOfAPixel) {
  FrontHalf front;
  for (int degrees : {5, 12, 17, 25, 30, 38}) {
    const Corners truth = square_corners({50.3, 49.6}, 48, degrees * std::numbers::pi / 180);
    const auto quads = front.quads(picture_of(truth));
    ASSERT_EQ(quads.size(), 1u) << degrees;
    EXPECT_LT(worst_offset(quads[0], truth), 0.3) << degrees;
  }
}

/// Mean offset of all corners from the truth over a grid of sub-pixel places.
Point mean_offset(double decimate, double side, double turn_rad) {
  FrontHalf front;
  front.preprocess.decimate = decimate;
  constexpr int kSteps = 8;
  Point sum;
  int count = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      // One period of the working grid, sampled in the middle of equal steps.
      const Point shift{decimate * (i + 0.5) / kSteps, decimate * (j + 0.5) / kSteps};
      const Corners truth = square_corners(Point{50, 50} + shift, side, turn_rad);
      const auto quads = front.quads(picture_of(truth));
      EXPECT_EQ(quads.size(), 1u);
      if (quads.size() != 1) continue;
      for (const Point p : truth) {
        sum = sum + nearest_offset(quads[0], p);
        ++count;
      }
    }
  }
  return (1.0 / count) * sum;
}

TEST(FitQuads, CornersAreUnbiasedOverSubPixelShifts) {
  for (double turn : {0.0, 0.1, 0.3, std::numbers::pi / 4}) {
    const Point bias = mean_offset(1.0, 30, turn);
    EXPECT_NEAR(bias.x, 0, 0.05) << turn;
    EXPECT_NEAR(bias.y, 0, 0.05) << turn;
  }
}

TEST(FitQuads, DecimationAddsNoBias) {
  for (double decimate : {1.5, 2.0, 3.0}) {
    const Point bias = mean_offset(decimate, 45, 0.3);
    EXPECT_NEAR(bias.x, 0, 0.05) << decimate;
    EXPECT_NEAR(bias.y, 0, 0.05) << decimate;
  }
}

TEST(FitQuads, CornersRunCounterClockwiseAsSeen) {
  FrontHalf front;
  const auto quads = front.quads(picture_of(square_corners({50, 50}, 30, 0.2)));
  ASSERT_EQ(quads.size(), 1u);
  EXPECT_LT(signed_area(quads[0].corners), 0);
}

TEST(FitQuads, BlackInsideWhiteIsANormalBorder) {
  FrontHalf front;
  const auto quads = front.quads(picture_of(square_corners({50, 50}, 30)));
  ASSERT_EQ(quads.size(), 1u);
  EXPECT_FALSE(quads[0].reversed_border);
}

TEST(FitQuads, WhiteInsideBlackIsAReversedBorder) {
  FrontHalf front;
  Image image(100, 100, static_cast<std::uint8_t>(kInk));
  paint_polygon(image, square_corners({50, 50}, 30), kPaper);
  const auto quads = front.quads(image);
  ASSERT_EQ(quads.size(), 1u);
  EXPECT_TRUE(quads[0].reversed_border);
}

TEST(FitQuads, BordersThatNoFamilyWantsAreRefused) {
  FrontHalf front;
  front.quad.normal_borders = false;
  EXPECT_TRUE(front.quads(picture_of(square_corners({50, 50}, 30))).empty());
  EXPECT_EQ(front.stats.wrong_border_colour, 1);
}

TEST(FitQuads, TwoSquaresAPixelApartAreBothFound) {
  Image image(60, 30, kPaper);
  const Corners left = square_corners({15, 15}, 20), right = square_corners({36, 15}, 20);
  paint_polygon(image, left, kInk);
  paint_polygon(image, right, kInk);
  FrontHalf front;
  const auto quads = front.quads(image);
  ASSERT_EQ(quads.size(), 2u);
  EXPECT_LT(worst_offset(quads[0], left), 0.05);
  EXPECT_LT(worst_offset(quads[1], right), 0.05);
}

TEST(FitQuads, SquaresThatTouchAtACornerAreBothFound) {
  Image image(60, 60, kPaper);
  const Corners first = square_corners({20, 20}, 20), second = square_corners({40, 40}, 20);
  paint_polygon(image, first, kInk);
  paint_polygon(image, second, kInk);
  FrontHalf front;
  const auto quads = front.quads(image);
  ASSERT_EQ(quads.size(), 2u);
  EXPECT_LT(worst_offset(quads[0], first), 0.3);
  EXPECT_LT(worst_offset(quads[1], second), 0.3);
}

TEST(FitQuads, APerspectiveViewIsFound) {
  FrontHalf front;
  const Corners truth = {{{12.3, 80.2}, {85.6, 70.1}, {70.4, 25.7}, {30.8, 18.4}}};
  const auto quads = front.quads(picture_of(truth));
  ASSERT_EQ(quads.size(), 1u);
  EXPECT_LT(worst_offset(quads[0], truth), 0.5);
}

TEST(FitQuads, DiscsAndTrianglesAreRefused) {
  FrontHalf front;
  Image disc(100, 100, kPaper);
  std::vector<Point> rim;
  for (int i = 0; i < 120; ++i) {
    const double angle = i * std::numbers::pi / 60;
    rim.push_back({50 + 40 * std::cos(angle), 50 + 40 * std::sin(angle)});
  }
  paint_polygon(disc, rim, kInk);
  front.quad.max_line_fit_mse_px2 = 1.0;  // four chords of this disc are 2.6 px off at the middle
  EXPECT_TRUE(front.quads(disc).empty());
  EXPECT_EQ(front.stats.bad_fit + front.stats.no_corners, 1);

  Image triangle(100, 100, kPaper);
  paint_polygon(triangle, std::vector<Point>{{10, 90}, {90, 90}, {50, 10}}, kInk);
  EXPECT_TRUE(front.quads(triangle).empty());
}

TEST(FitQuads, QuadsBelowTheSmallestSideAreRefused) {
  FrontHalf front;
  front.quad.min_side_px = 12;
  EXPECT_EQ(front.quads(picture_of(square_corners({50, 50}, 14))).size(), 1u);
  EXPECT_TRUE(front.quads(picture_of(square_corners({50, 50}, 10))).empty());
  EXPECT_EQ(front.stats.clusters_too_small, 1);
  // Its bounding box is large enough, its area is not.
  EXPECT_TRUE(front.quads(picture_of(square_corners({50, 50}, 11, 0.7))).empty());
  EXPECT_EQ(front.stats.bad_shape, 1);
}

TEST(FitQuads, FlatQuadsAreRefused) {
  FrontHalf front;
  front.quad.critical_angle_deg = 20;
  const Corners lozenge = {{{10, 50}, {50, 56}, {90, 50}, {50, 44}}};
  EXPECT_TRUE(front.quads(picture_of(lozenge)).empty());
  EXPECT_EQ(front.stats.quads, 0);
}

TEST(FitQuads, ARaggedContourIsRefusedBeforeItIsSorted) {
  // A black comb whose teeth give it far more boundary than a convex shape of its size.
  Image image(80, 80, kPaper);
  for (int y = 10; y < 70; ++y) {
    for (int x = 10; x < 70; ++x) {
      if (x % 2 == 0 || y > 66) image.at(x, y) = static_cast<std::uint8_t>(kInk);
    }
  }
  FrontHalf front;
  EXPECT_TRUE(front.quads(image).empty());
  EXPECT_GE(front.stats.clusters_too_large, 1);
}

TEST(FitQuads, ABoundaryThatDoesNotCloseIsRefusedBeforeItIsSorted) {
  // Black left of a slanted line across the whole image.
  Image image(80, 80, kPaper);
  paint_polygon(image, std::vector<Point>{{0, 0}, {30, 0}, {50, 80}, {0, 80}}, kInk);
  FrontHalf front;
  EXPECT_TRUE(front.quads(image).empty());
  EXPECT_EQ(front.stats.clusters_open, 1);
}

TEST(FitQuads, AnOpenRingIsRefusedBecauseItDoesNotFillItsQuad) {
  // Outer and inner side of the ring are one contour, 3 px to both sides of a square that fits.
  Image image(80, 80, kPaper);
  paint_polygon(image, square_corners({40, 40}, 48), kInk);
  paint_polygon(image, square_corners({40, 40}, 36), kPaper);
  paint_polygon(image, std::vector<Point>{{38, 10}, {42, 10}, {42, 30}, {38, 30}}, kPaper);
  FrontHalf front;
  front.quad.max_line_fit_mse_px2 = 100;
  EXPECT_TRUE(front.quads(image).empty());
  EXPECT_EQ(front.stats.bad_shape, 1);
}

TEST(FitQuads, ASquareCutByTheImageBorderNeitherCrashesNorCounts) {
  FrontHalf front;
  for (const Point center : {Point{2, 50}, Point{99, 97}, Point{50, -5}}) {
    for (const Quad& quad : front.quads(picture_of(square_corners(center, 30, 0.2)))) {
      EXPECT_LT(signed_area(quad.corners), 0);
    }
  }
}

TEST(FitQuads, ASquareThatTouchesTheImageBorderByAPixelIsFound) {
  FrontHalf front;
  const Corners truth = square_corners({16, 16}, 30);  // from 1 to 31
  const auto quads = front.quads(picture_of(truth, 32));
  ASSERT_EQ(quads.size(), 1u);
  EXPECT_LT(worst_offset(quads[0], truth), 0.05);
}

TEST(FitQuads, TheOrderOfThePointsDoesNotMatter) {
  FrontHalf front;
  const Image image = picture_of(square_corners({50.2, 50.7}, 33, 0.4));
  const auto before = front.quads(image);
  ASSERT_EQ(before.size(), 1u);
  std::vector<BoundaryPoint> shuffled(front.clusters.points);
  testing::FixedRandom random(4);
  for (std::size_t i = shuffled.size(); i > 1; --i) {
    std::swap(shuffled[i - 1], shuffled[random.bits() % i]);
  }
  const auto after = fit_quad(shuffled, image, front.quad, front.quad_scratch, front.stats);
  ASSERT_TRUE(after);
  for (int i = 0; i < 4; ++i) EXPECT_LT(length(after->corners[i] - before[0].corners[i]), 1e-6);
}

TEST(FitQuads, EveryClusterIsCountedOnce) {
  testing::FixedRandom random(6);
  Image image(160, 120);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) image.at(x, y) = std::uint8_t(random.between(0, 255));
  }
  paint_polygon(image, square_corners({60, 60}, 40), kInk);
  FrontHalf front;
  front.quads(image);
  const DetectStats& s = front.stats;
  EXPECT_GT(s.clusters, 0);
  EXPECT_EQ(s.clusters, s.clusters_too_large + s.clusters_open + s.clusters_too_small +
                            s.wrong_border_colour + s.no_corners + s.bad_fit + s.bad_shape +
                            s.quads);
}

TEST(FitQuads, NoiseOfAnySizePassesThroughAllStages) {
  testing::FixedRandom random(8);
  for (int round = 0; round < 150; ++round) {
    Image image(random.between(0, 60), random.between(0, 40));
    const int blocks = random.between(1, 5);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const bool copy = x % blocks != 0;
        image.at(x, y) = copy ? image.at(x - 1, y) : std::uint8_t(random.between(0, 255));
      }
    }
    FrontHalf front;
    front.preprocess = {round % 3 == 0 ? 1.0 : random.real(1, 4), random.real(-1, 1)};
    front.cluster.min_points = 1;
    front.quad.max_line_fit_mse_px2 = 1e6;
    front.quad.critical_angle_deg = 0;
    front.quad.min_side_px = 0;
    front.quad.max_corner_candidates = random.between(4, kMaxCornerCandidates);
    for (const Quad& quad : front.quads(image)) {
      for (const Point p : quad.corners) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
    }
  }
}

TEST(FitQuads, TinyImagesHaveNoQuads) {
  FrontHalf front;
  for (int width = 0; width <= 8; ++width) {
    for (int height = 0; height <= 8; ++height) {
      Image image(width, height, kPaper);
      for (int i = 0; i < width * height; i += 2) image.at(i % width, i / width) = 0;
      EXPECT_TRUE(front.quads(image).empty()) << width << " x " << height;
    }
  }
}

}  // namespace
}  // namespace tagmint::detect
