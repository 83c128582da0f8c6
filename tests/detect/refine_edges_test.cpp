#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/s6_refine_edges.h"
#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::detect {
namespace {

using testing::Canvas;
using testing::FixedRandom;

const codec::SharedFamily& family() {
  static const codec::SharedFamily made =
      testing::random_family("refine", codec::classic_layout(8), 5, 8);
  return made;
}

struct Errors {
  double median_px = 0;
  double worst_px = 0;
  double mean_scale = 0;  ///< mean of found side / true side - 1
};

/// Paints tags of one side at random places and turns, moves their true corners by up to
/// `start_error_px`, refines, and compares.
Errors refine_many(double side_px, double start_error_px, double noise, bool reversed = false,
                   const RefineOptions& options = {.search_px = 2, .cells_at_border = 6}) {
  FixedRandom random(42);
  std::vector<double> errors;
  double scale_sum = 0;
  constexpr int kTags = 24;
  const int size = static_cast<int>(2.2 * side_px) + 12;
  for (int trial = 0; trial < kTags; ++trial) {
    Canvas canvas(size, size, 160);
    const Homography truth =
        testing::square_at({size / 2.0 + random.real(-1, 1), size / 2.0 + random.real(-1, 1)},
                           side_px, random.real(0, 2 * std::numbers::pi));
    const testing::Ink ink = reversed ? testing::Ink{.black = 210, .white = 40}
                                      : testing::Ink{.black = 40, .white = 210};
    testing::paint_tag(canvas, *family(), static_cast<codec::TagId>(trial % family()->size()),
                       truth, ink);
    testing::blur(canvas, 0.5);
    const Image image = testing::to_gray(canvas, noise, random);
    const Corners corners = testing::corners_of(truth);
    Quad quad{corners, reversed};
    for (Point& p : quad.corners) {
      p = p + Point{random.real(-start_error_px, start_error_px),
                    random.real(-start_error_px, start_error_px)};
    }
    const Quad refined = refine_edges(image, quad, options);
    for (int i = 0; i < 4; ++i) errors.push_back(length(refined.corners[i] - corners[i]));
    scale_sum +=
        std::sqrt(std::abs(signed_area(refined.corners)) / std::abs(signed_area(corners))) - 1;
  }
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors.back(), scale_sum / kTags};
}

TEST(RefineEdges, CornersOfACleanTagAreRightToAFewHundredthsOfAPixel) {
  const Errors errors = refine_many(60, 0.7, 0);
  EXPECT_LT(errors.median_px, 0.015);
  EXPECT_LT(errors.worst_px, 0.15);
}

TEST(RefineEdges, CornersOfANoisyTagStayBelowATwentiethOfAPixel) {
  const Errors errors = refine_many(40, 0.7, 5);
  EXPECT_LT(errors.median_px, 0.05);
}

TEST(RefineEdges, SizeIsWithoutBiasDownToFourPixelsACell) {
  EXPECT_LT(std::abs(refine_many(24, 0.5, 2).mean_scale), 0.001);
  EXPECT_LT(std::abs(refine_many(48, 0.5, 2).mean_scale), 0.0003);
}

TEST(RefineEdges, SmallTagsAreMeasuredFarBetterThanByTheMeanOfTheGradient) {
  // 2.5 px a cell; without the number of cells the mean of the gradient is used.
  const Errors own = refine_many(15, 0.4, 2);
  const Errors mean = refine_many(15, 0.4, 2, false, {.search_px = 2, .cells_at_border = 0});
  EXPECT_LT(own.median_px, 0.05);
  EXPECT_LT(std::abs(own.mean_scale), 0.003);
  EXPECT_LT(own.median_px, mean.median_px);
}

TEST(RefineEdges, ReversedBordersAreRefinedAsWell) {
  EXPECT_LT(refine_many(60, 0.7, 0, true).median_px, 0.015);
}

TEST(RefineEdges, AWideSearchFindsEdgesFartherAway) {
  const Errors errors = refine_many(90, 3.0, 0, false, {.search_px = 5, .cells_at_border = 6});
  EXPECT_LT(errors.median_px, 0.03);
}

TEST(RefineEdges, AFlatImageLeavesTheQuadAsItIs) {
  const Image flat(50, 50, 128);
  const Quad quad{{{{10, 40}, {40, 40}, {40, 10}, {10, 10}}}, false};
  const Quad refined = refine_edges(flat, quad, {});
  for (int i = 0; i < 4; ++i) EXPECT_LT(length(refined.corners[i] - quad.corners[i]), 1e-9);
}

TEST(RefineEdges, EdgesOfTheWrongSenseAreNotTaken) {
  // A bright square, looked at as if it were dark: the only edges there have the wrong sign.
  Image image(60, 60, 20);
  for (int y = 15; y < 45; ++y) {
    for (int x = 15; x < 45; ++x) image.at(x, y) = 220;
  }
  const Quad quad{{{{14.5, 45.5}, {45.5, 45.5}, {45.5, 14.5}, {14.5, 14.5}}}, false};
  const Quad refined = refine_edges(image, quad, {});
  for (int i = 0; i < 4; ++i) EXPECT_LT(length(refined.corners[i] - quad.corners[i]), 1e-9);
}

TEST(RefineEdges, ASideWithoutAnEdgeKeepsItsLine) {
  // Dark to the image's left edge: three sides have an edge, the left one has none.
  Image image(60, 60, 220);
  for (int y = 15; y < 45; ++y) {
    for (int x = 0; x < 45; ++x) image.at(x, y) = 20;
  }
  const Quad quad{{{{20, 45.4}, {45.4, 45.4}, {45.4, 14.6}, {20, 14.6}}}, false};
  const Quad refined = refine_edges(image, quad, {});
  EXPECT_LT(length(refined.corners[0] - Point{20, 45}), 0.05);
  EXPECT_LT(length(refined.corners[1] - Point{45, 45}), 0.05);
  EXPECT_LT(length(refined.corners[2] - Point{45, 15}), 0.05);
  EXPECT_LT(length(refined.corners[3] - Point{20, 15}), 0.05);
}

TEST(RefineEdges, QuadsAcrossOrOutsideTheImageComeBackFinite) {
  FixedRandom random(9);
  Image image(40, 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) image.at(x, y) = static_cast<std::uint8_t>(random.between(0, 255));
  }
  for (int trial = 0; trial < 300; ++trial) {
    const Homography h = testing::square_at({random.real(-20, 60), random.real(-20, 60)},
                                            random.real(1, 60), random.real(0, 6));
    const Quad refined = refine_edges(image, {testing::corners_of(h), trial % 2 == 0}, {});
    EXPECT_LT(signed_area(refined.corners), 0);
    for (const Point p : refined.corners) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  }
}

}  // namespace
}  // namespace tagmint::detect
