#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "pipeline/s3_segment.h"
#include "pipeline/s4_cluster.h"
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

Clusters run(ImageView image, const ClusterOptions& options = {1, 0}) {
  ClusterScratch scratch;
  DetectStats stats;
  Clusters clusters;
  cluster(components_of(image), options, scratch, clusters, stats);
  EXPECT_EQ(stats.clusters, static_cast<std::int64_t>(clusters.count()));
  return clusters;
}

using Plain = std::tuple<double, double, double, double>;

/// The points as tuples, sorted.
std::vector<Plain> plain(std::span<const BoundaryPoint> points) {
  std::vector<Plain> out;
  for (const BoundaryPoint& p : points) out.emplace_back(p.x, p.y, p.gx, p.gy);
  std::sort(out.begin(), out.end());
  return out;
}

/// Fig. 4 of the paper pixel by pixel with an ordered map; all sorted.
std::vector<std::vector<Plain>> naive(const Image& image, const ClusterOptions& options) {
  constexpr std::array<std::array<int, 2>, 4> kSteps = {{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
  const Components components = components_of(image);
  const std::vector<std::uint32_t> of_pixel = component_of_each_pixel(components);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> number;
  std::vector<std::vector<Plain>> found;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (const auto [dx, dy] : kSteps) {
        const int u = x + dx, v = y + dy;
        if (u < 0 || u >= image.width() || v >= image.height()) continue;
        if (image.at(x, y) + image.at(u, v) != 255) continue;
        const std::uint32_t a = of_pixel[y * image.width() + x];
        const std::uint32_t b = of_pixel[v * image.width() + u];
        if (int(components.size[a]) < options.min_component_pixels) continue;
        if (int(components.size[b]) < options.min_component_pixels) continue;
        const auto [at, fresh] = number.try_emplace(std::minmax(a, b), found.size());
        if (fresh) found.emplace_back();
        const int sign = image.at(x, y) == kBlack ? 1 : -1;
        found[at->second].emplace_back((x + u + 1) / 2.0, (y + v + 1) / 2.0, sign * dx, sign * dy);
      }
    }
  }
  for (auto& points : found) std::sort(points.begin(), points.end());
  std::erase_if(found, [&](const auto& c) { return std::ssize(c) < options.min_points; });
  std::sort(found.begin(), found.end());
  return found;
}

void expect_equal_to_naive(const Image& image, const ClusterOptions& options) {
  const Clusters clusters = run(image, options);
  std::vector<std::vector<Plain>> found;
  for (std::size_t i = 0; i < clusters.count(); ++i) found.push_back(plain(clusters.cluster(i)));
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, naive(image, options));
}

TEST(Cluster, APointLiesHalfWayBetweenTheCentresOfItsPixels) {
  EXPECT_EQ(plain(run(ascii_image({"#."})).points), (std::vector<Plain>{{1, 0.5, 1, 0}}));
  EXPECT_EQ(plain(run(ascii_image({".",  //
                                   "#"}))
                      .points),
            (std::vector<Plain>{{0.5, 1, 0, -1}}));
}

TEST(Cluster, TheBoundaryOfOnePixelHasItsFourEdgesAndFourCorners) {
  const Clusters clusters = run(ascii_image({"...",  //
                                             ".#.",  //
                                             "..."}));
  ASSERT_EQ(clusters.count(), 1u);
  EXPECT_EQ(plain(clusters.points), (std::vector<Plain>{{1, 1, -1, -1},
                                                        {1, 1.5, -1, 0},
                                                        {1, 2, -1, 1},
                                                        {1.5, 1, 0, -1},
                                                        {1.5, 2, 0, 1},
                                                        {2, 1, 1, -1},
                                                        {2, 1.5, 1, 0},
                                                        {2, 2, 1, 1}}));
}

TEST(Cluster, AWhiteLineOnePixelWideBelongsToTheBoundariesOfBothBlackSquares) {
  const Clusters clusters = run(ascii_image({".........",  //
                                             ".###.###.",  //
                                             ".###.###.",  //
                                             ".###.###.",  //
                                             "........."}));
  ASSERT_EQ(clusters.count(), 2u);
  EXPECT_EQ(clusters.cluster(0).size(), clusters.cluster(1).size());
  const auto on_the_line = [](std::span<const BoundaryPoint> points, float x) {
    return std::count_if(points.begin(), points.end(),
                         [x](const BoundaryPoint& p) { return p.x == x; });
  };
  EXPECT_GE(on_the_line(clusters.cluster(0), 4), 3);
  EXPECT_GE(on_the_line(clusters.cluster(1), 5), 3);
  EXPECT_EQ(on_the_line(clusters.cluster(0), 5), 0);
}

TEST(Cluster, BoundariesOfOneComponentWithTwoOthersStayApart) {
  // A black ring: its outer and its inner edge are two clusters.
  const Clusters clusters = run(ascii_image({".......",  //
                                             ".#####.",  //
                                             ".#...#.",  //
                                             ".#...#.",  //
                                             ".#...#.",  //
                                             ".#####.",  //
                                             "......."}));
  ASSERT_EQ(clusters.count(), 2u);
  EXPECT_GT(clusters.cluster(0).size(), clusters.cluster(1).size());
}

TEST(Cluster, UnknownPixelsMakeNoBoundary) {
  EXPECT_EQ(run(ascii_image({"#?.",  //
                             "???",  //
                             ".?#"}))
                .count(),
            0u);
}

TEST(Cluster, ShortBoundariesAreDropped) {
  const Image image = ascii_image({"......",  //
                                   ".#....",  //
                                   "...##.",  //
                                   "...##.",  //
                                   "......"});
  EXPECT_EQ(run(image, {1, 0}).count(), 2u);
  EXPECT_EQ(run(image, {9, 0}).count(), 1u);
  EXPECT_EQ(run(image, {100, 0}).count(), 0u);
}

TEST(Cluster, SmallComponentsTakeNoPart) {
  const Image image = ascii_image({"......",  //
                                   ".#....",  //
                                   "...##.",  //
                                   "...##.",  //
                                   "......"});
  EXPECT_EQ(run(image, {1, 1}).count(), 2u);
  EXPECT_EQ(run(image, {1, 2}).count(), 1u);
  EXPECT_EQ(run(image, {1, 5}).count(), 0u);
}

TEST(Cluster, TheSmallestRingIsAsLargeAsItsDrawing) {
  const Image ring = ascii_image({"####",  //
                                  "#..#",  //
                                  "#..#",  //
                                  "####"});
  EXPECT_EQ(static_cast<int>(components_of(ring).size[0]), smallest_ring_pixels(4));
  EXPECT_EQ(smallest_ring_pixels(0), 1);
}

TEST(Cluster, AgreesWithAnOrderedMapOnRandomPicturesOfOddSizes) {
  testing::FixedRandom random(9);
  for (int round = 0; round < 120; ++round) {
    Image image(random.between(0, 41), random.between(0, 17));
    const int unknown = random.between(0, 30);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        image.at(x, y) = random.between(0, 99) < unknown ? kUnknown
                         : random.between(0, 3) > 0      ? kWhite
                                                         : kBlack;
      }
    }
    expect_equal_to_naive(image, {random.between(1, 12), random.between(0, 4)});
  }
}

TEST(Cluster, ManyMoreClustersThanTheTableHasSlotsAreAllKept) {
  Image image(201, 101, kWhite);
  for (int y = 1; y < 101; y += 2) {
    for (int x = 1; x < 201; x += 2) image.at(x, y) = kBlack;
  }
  expect_equal_to_naive(image, {1, 0});
}

TEST(Cluster, ClustersAreInTheOrderOfTheirFirstRows) {
  const Clusters clusters = run(ascii_image({"........",  //
                                             ".....##.",  //
                                             ".##..##.",  //
                                             ".##.....",  //
                                             "........"}));
  ASSERT_EQ(clusters.count(), 2u);
  EXPECT_EQ(clusters.cluster(0)[0].y, 1);
  EXPECT_EQ(clusters.cluster(1)[0].y, 2);
}

TEST(Cluster, BuffersOfAnEarlierImageDoNotShow) {
  ClusterScratch scratch;
  DetectStats stats;
  Clusters first, second;
  const Image noisy = ascii_image({"#.#.#.", ".#.#.#", "#.#.#."});
  const Image image = ascii_image({"......", ".##...", "......"});
  cluster(components_of(noisy), {1, 0}, scratch, first, stats);
  cluster(components_of(image), {1, 0}, scratch, second, stats);
  EXPECT_EQ(plain(second.points), plain(run(image).points));
}

}  // namespace
}  // namespace tagmint::detect
