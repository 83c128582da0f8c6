#include "numerics/line_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/fixed_random.h"

namespace tagmint::detect {
namespace {

struct Cloud {
  std::vector<Point> points;
  std::vector<double> weights;
};

Cloud random_cloud(int n, testing::FixedRandom& random) {
  Cloud cloud;
  const double slope = random.real(-3, 3);
  for (int i = 0; i < n; ++i) {
    const double x = random.real(-50, 50);
    cloud.points.push_back({x, slope * x + random.real(-4, 4)});
    cloud.weights.push_back(random.real(0.1, 9));
  }
  return cloud;
}

/// Indices i0 .. i1 of a closed contour of n points.
std::vector<int> indices_between(int i0, int i1, int n) {
  std::vector<int> indices{i0};
  while (indices.back() != i1) indices.push_back((indices.back() + 1) % n);
  return indices;
}

/// Weighted mean squared distance from the line through the centroid whose normal has this angle.
double mse_at(const Cloud& cloud, const std::vector<int>& indices, double angle_rad) {
  double w = 0;
  Point centroid;
  for (int i : indices) {
    w += cloud.weights[i];
    centroid = centroid + cloud.weights[i] * cloud.points[i];
  }
  centroid = (1 / w) * centroid;
  const Point normal{std::cos(angle_rad), std::sin(angle_rad)};
  double sum = 0;
  for (int i : indices) {
    const double distance = dot(cloud.points[i] - centroid, normal);
    sum += cloud.weights[i] * distance * distance;
  }
  return sum / w;
}

TEST(LineFit, NoOtherDirectionFitsBetterThanTheFittedLine) {
  testing::FixedRandom random(11);
  std::vector<LineMoments> moments;
  for (int round = 0; round < 30; ++round) {
    const int n = random.between(3, 40);
    const Cloud cloud = random_cloud(n, random);
    line_moments(cloud.points, cloud.weights, moments);
    const int i0 = random.between(0, n - 1), i1 = (i0 + random.between(1, n - 1)) % n;
    const LineFit fit = fit_line(moments_between(moments, i0, i1));
    const std::vector<int> indices = indices_between(i0, i1, n);

    EXPECT_NEAR(length(fit.normal), 1, 1e-12);
    EXPECT_NEAR(mse_at(cloud, indices, std::atan2(fit.normal.y, fit.normal.x)), fit.mse, 1e-9);
    for (int degree = 0; degree < 180; ++degree) {
      EXPECT_GE(mse_at(cloud, indices, degree * std::numbers::pi / 180), fit.mse - 1e-9);
    }
    EXPECT_DOUBLE_EQ(line_fit_mse(moments_between(moments, i0, i1)), fit.mse);
  }
}

TEST(LineFit, SumsOfARangeWrapPastTheEnd) {
  const std::vector<Point> points = {{1, 0}, {2, 0}, {4, 0}, {8, 0}};
  const std::vector<double> weights = {1, 1, 1, 1};
  std::vector<LineMoments> moments;
  line_moments(points, weights, moments);
  EXPECT_EQ(moments_between(moments, 1, 2).x, 6);
  EXPECT_EQ(moments_between(moments, 3, 1).x, 11);
  EXPECT_EQ(moments_between(moments, 0, 3).x, 15);
  EXPECT_EQ(moments_between(moments, 2, 2).w, 1);
}

TEST(LineFit, PointsOnALineFitExactly) {
  const std::vector<Point> upright = {{3, 0}, {3, 1}, {3, 2}};
  const std::vector<Point> level = {{0, 5}, {1, 5}, {2, 5}};
  const std::vector<double> weights = {1, 2, 3};
  std::vector<LineMoments> moments;
  line_moments(upright, weights, moments);
  EXPECT_NEAR(std::abs(fit_line(moments.back()).normal.x), 1, 1e-12);
  line_moments(level, weights, moments);
  EXPECT_NEAR(std::abs(fit_line(moments.back()).normal.y), 1, 1e-12);
  EXPECT_NEAR(fit_line(moments.back()).mse, 0, 1e-12);
}

TEST(LineFit, ASinglePointHasAUnitNormalAllTheSame) {
  const std::vector<Point> points = {{3, 4}};
  const std::vector<double> weights = {2};
  std::vector<LineMoments> moments;
  line_moments(points, weights, moments);
  const LineFit fit = fit_line(moments.back());
  EXPECT_EQ(length(fit.normal), 1);
  EXPECT_EQ(fit.mse, 0);
}

TEST(LineFit, LinesMeetWhereBothEquationsHold) {
  const LineFit a{{0, 2}, {0, 1}, 0};                             // y = 2
  const LineFit b{{1, 1}, {std::sqrt(0.5), -std::sqrt(0.5)}, 0};  // y = x
  const std::optional<Point> met = intersect(a, b);
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->x, 2, 1e-12);
  EXPECT_NEAR(met->y, 2, 1e-12);
}

TEST(LineFit, ParallelLinesDoNotMeet) {
  const LineFit a{{0, 2}, {0, 1}, 0};
  const LineFit b{{5, 7}, {0, -1}, 0};
  EXPECT_FALSE(intersect(a, b));
  EXPECT_FALSE(intersect(a, a));
}

}  // namespace
}  // namespace tagmint::detect
