#include "pipeline/outline.h"

#include <gtest/gtest.h>

#include "pipeline/s3_segment.h"
#include "pipeline/s4_cluster.h"
#include "pipeline/s5_fit_quads.h"
#include "support/ascii_image.h"
#include "support/fixed_random.h"

namespace tagmint::detect {
namespace {

using testing::ascii_image;

Components components_of(ImageView image) {
  SegmentScratch scratch;
  Components components;
  segment(image, scratch, components);
  return components;
}

Clusters clusters_of(const Components& components, const ClusterOptions& options,
                     DetectStats& stats) {
  ClusterScratch scratch;
  Clusters clusters;
  cluster(components, options, scratch, clusters, stats);
  return clusters;
}

/// Blobs of some pixels, so that shapes of all sizes come up.
Image random_blobs(int width, int height, testing::FixedRandom& random) {
  Image image(width, height, kWhite);
  for (int blob = random.between(0, 14); blob > 0; --blob) {
    const int x0 = random.between(0, width - 1), y0 = random.between(0, height - 1);
    const int w = random.between(1, 14), h = random.between(1, 14);
    const std::uint8_t value = random.between(0, 3) > 0 ? kBlack : kWhite;
    for (int y = y0; y < std::min(height, y0 + h); ++y) {
      for (int x = x0; x < std::min(width, x0 + w); ++x) image.at(x, y) = value;
    }
  }
  return image;
}

TEST(Outline, OfASquareHasItsBoxItsAreaAndThreePointsForEachPixelOfItsSides) {
  const Image square = ascii_image({"......",  //
                                    ".####.",  //
                                    ".####.",  //
                                    ".####.",  //
                                    ".####.",  //
                                    "......"});
  DetectStats stats;
  const Clusters clusters = clusters_of(components_of(square), {1, 0}, stats);
  ASSERT_EQ(clusters.count(), 1u);
  const Outline outline = outline_of(clusters.cluster(0));
  EXPECT_EQ(outline.left, 1);
  EXPECT_EQ(outline.right, 5);
  EXPECT_EQ(outline.width(), 4);
  EXPECT_EQ(outline.height(), 4);
  EXPECT_EQ(outline.black_area, 16);
  EXPECT_EQ(outline.points, 16 + 2 * 12 + 4);
  EXPECT_FALSE(outline.reversed());
}

TEST(Outline, OfAWhiteHoleInBlackIsReversed) {
  const Image hole = ascii_image({"#####",  //
                                  "#...#",  //
                                  "#...#",  //
                                  "#####"});
  DetectStats stats;
  const Clusters clusters = clusters_of(components_of(hole), {1, 0}, stats);
  ASSERT_EQ(clusters.count(), 1u);
  EXPECT_EQ(outline_of(clusters.cluster(0)).black_area, -6);
  EXPECT_TRUE(outline_of(clusters.cluster(0)).reversed());
}

/// The clusters of a picture, and their outlines from the stretches alone.
void expect_sums_equal_to_points(const Image& image) {
  const Components components = components_of(image);
  ClusterScratch scratch;
  Clusters clusters;
  DetectStats stats;
  cluster(components, {1, 0}, scratch, clusters, stats);
  ASSERT_EQ(scratch.outlines.size(), clusters.count());
  for (std::size_t i = 0; i < clusters.count(); ++i) {
    EXPECT_EQ(scratch.outlines[i].outline(), outline_of(clusters.cluster(i)));
  }
}

TEST(Outline, FromStretchesEqualsThatFromPointsOnRandomPicturesOfOddSizes) {
  testing::FixedRandom random(3);
  for (int round = 0; round < 100; ++round) {
    expect_sums_equal_to_points(random_blobs(random.between(1, 45), random.between(1, 33), random));
  }
}

TEST(Outline, IsRefusedForItsReason) {
  const OutlineLimits limits{.min_side_px = 4, .normal_borders = true, .reversed_borders = false};
  const Outline square{.right = 10, .bottom = 10, .black_area = 100, .points = 112};
  EXPECT_EQ(judge_outline(square, limits), OutlineVerdict::Promising);
  Outline other = square;
  other.right = 1;
  EXPECT_EQ(judge_outline(other, limits), OutlineVerdict::TooSmall);
  other = square;
  other.points = 400;
  EXPECT_EQ(judge_outline(other, limits), OutlineVerdict::TooManyPoints);
  other.points = 40;
  EXPECT_EQ(judge_outline(other, limits), OutlineVerdict::Open);
  other = square;
  other.black_area = -100;
  EXPECT_EQ(judge_outline(other, limits), OutlineVerdict::WrongColour);
  other.black_area = 5;
  EXPECT_EQ(judge_outline(other, limits), OutlineVerdict::TooSmall);
}

TEST(Outline, LimitsLeaveTheQuadsOfAllBoundariesOfThatColour) {
  testing::FixedRandom random(8);
  int quads = 0;
  for (int round = 0; round < 200; ++round) {
    const Image image = random_blobs(60, 45, random);
    const Components components = components_of(image);
    for (const bool normal : {true, false}) {
      const QuadOptions quad_options{.normal_borders = normal, .reversed_borders = !normal};
      const OutlineLimits limits{.normal_borders = normal, .reversed_borders = !normal};
      const auto quads_of = [&](const ClusterOptions& options) {
        DetectStats stats;
        QuadScratch scratch;
        std::vector<Corners> found;
        const Clusters clusters = clusters_of(components, options, stats);
        for (std::size_t i = 0; i < clusters.count(); ++i) {
          if (const auto quad =
                  fit_quad(clusters.cluster(i), image, quad_options, scratch, stats)) {
            found.push_back(quad->corners);
          }
        }
        return found;
      };
      const auto all = quads_of({.min_points = 24});
      EXPECT_EQ(quads_of({.min_points = 24, .limits = limits}), all) << round;
      quads += static_cast<int>(all.size());
    }
  }
  EXPECT_GT(quads, 100);
}

}  // namespace
}  // namespace tagmint::detect
