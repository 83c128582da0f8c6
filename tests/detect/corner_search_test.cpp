#include "numerics/corner_search.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/fixed_random.h"

namespace tagmint::detect {
namespace {

/// Points a step apart along a closed polygon, starting at its first corner.
std::vector<Point> walk(const std::vector<Point>& polygon, double step) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point from = polygon[i], to = polygon[(i + 1) % polygon.size()];
    const int steps = static_cast<int>(length(to - from) / step);
    for (int k = 0; k < steps; ++k) {
      points.push_back(from + (double(k) / steps) * (to - from));
    }
  }
  return points;
}

std::vector<LineMoments> moments_of(const std::vector<Point>& points) {
  std::vector<LineMoments> moments;
  line_moments(points, std::vector<double>(points.size(), 1.0), moments);
  return moments;
}

const std::vector<Point> kSquare = {{-10, 10}, {10, 10}, {10, -10}, {-10, -10}};

TEST(CornerSearch, TheCornersOfASquareAreTheOnlyPeaks) {
  const auto moments = moments_of(walk(kSquare, 0.5));
  CornerScratch scratch;
  const auto peaks = find_corner_candidates(moments, 10, scratch);
  EXPECT_EQ(std::vector<int>(peaks.begin(), peaks.end()), (std::vector<int>{0, 40, 80, 120}));
}

TEST(CornerSearch, AContourTooShortForAWindowHasNoCandidates) {
  const auto moments = moments_of(walk({{0, 0}, {0, 5}, {5, 5}, {5, 0}}, 1));  // 20 points
  CornerScratch scratch;
  EXPECT_TRUE(find_corner_candidates(moments, 10, scratch).empty());
  EXPECT_TRUE(find_corner_candidates({}, 10, scratch).empty());
}

TEST(CornerSearch, OnlyTheStrongestPeaksAreKeptInContourOrder) {
  // A square whose sides also bend a little in the middle: eight corners, four of them sharp.
  const std::vector<Point> star = {{-10, 10}, {0, 9},  {10, 10},   {9, 0},
                                   {10, -10}, {0, -9}, {-10, -10}, {-9, 0}};
  const auto moments = moments_of(walk(star, 0.25));
  CornerScratch scratch;
  const auto eight = find_corner_candidates(moments, 10, scratch);
  EXPECT_EQ(eight.size(), 8u);
  const auto four = find_corner_candidates(moments, 4, scratch);
  EXPECT_EQ(std::vector<int>(four.begin(), four.end()), (std::vector<int>{0, 80, 160, 240}));
}

TEST(CornerSearch, TheTrueCornersAreChosenAmongOthers) {
  const auto moments = moments_of(walk(kSquare, 0.5));
  CornerScratch scratch;
  const std::vector<int> candidates = {0, 13, 40, 55, 62, 80, 101, 120, 151};
  const auto best = choose_corners(moments, candidates, {10, 0.9}, scratch);
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->mse, 0, 1e-9);
  EXPECT_NEAR(best->sides[0].centroid.x, 0, 1e-9);
  EXPECT_NEAR(best->sides[0].centroid.y, 10, 1e-9);
  EXPECT_NEAR(best->sides[1].centroid.x, 10, 1e-9);
}

/// Every combination of four, each line fitted anew.
double smallest_error(std::span<const LineMoments> moments, const std::vector<int>& candidates,
                      const CornerLimits& limits) {
  double best = 1e300;
  const int n = static_cast<int>(candidates.size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      for (int c = b + 1; c < n; ++c) {
        for (int d = c + 1; d < n; ++d) {
          const int at[] = {candidates[a], candidates[b], candidates[c], candidates[d]};
          double error = 0;
          bool allowed = true;
          std::array<LineFit, 4> sides;
          for (int i = 0; i < 4; ++i) {
            const LineMoments sum = moments_between(moments, at[i], at[(i + 1) % 4]);
            sides[i] = fit_line(sum);
            error += sides[i].mse * sum.w;
            allowed = allowed && sides[i].mse <= limits.max_mse_px2;
          }
          for (int i = 0; i < 4; ++i) {
            const double cosine = std::abs(dot(sides[i].normal, sides[(i + 1) % 4].normal));
            allowed = allowed && cosine <= limits.max_corner_cosine;
          }
          if (allowed && error < best) best = error;
        }
      }
    }
  }
  return best;
}

TEST(CornerSearch, NoCombinationWithinTheLimitsIsBetterThanTheChosenOne) {
  testing::FixedRandom random(3);
  CornerScratch scratch;
  const CornerLimits limits{6, 0.98};
  int found = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Point> points = walk(kSquare, 0.7);
    for (Point& p : points) p = p + Point{random.real(-3, 3), random.real(-3, 3)};
    const auto moments = moments_of(points);
    std::vector<int> candidates;
    for (int i = random.between(0, 9); i < std::ssize(points); i += random.between(1, 18)) {
      candidates.push_back(i);
    }
    const double expected = smallest_error(moments, candidates, limits);
    const auto best = choose_corners(moments, candidates, limits, scratch);
    ASSERT_EQ(best.has_value(), expected < 1e300);
    if (!best) continue;
    ++found;
    double weight = 0;
    for (const LineFit& side : best->sides) EXPECT_LE(side.mse, limits.max_mse_px2);
    // Each side holds both its corners, so the four corners are counted twice.
    weight = static_cast<double>(points.size()) + 4;
    EXPECT_NEAR(best->mse, expected / weight, 1e-9);
  }
  EXPECT_GT(found, 10);
}

TEST(CornerSearch, NoFourCornersWhereTheSidesAreTooRough) {
  std::vector<Point> points = walk(kSquare, 0.5);
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] = 0.5 * points[i];
  CornerScratch scratch;
  const auto moments = moments_of(points);
  EXPECT_FALSE(choose_corners(moments, std::vector<int>{0, 40, 80, 120}, {0.1, 1}, scratch));
  EXPECT_FALSE(choose_corners(moments, std::vector<int>{0, 40, 80}, {100, 1}, scratch));
}

}  // namespace
}  // namespace tagmint::detect
