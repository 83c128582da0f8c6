#include "draw/path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tagmint::draw {
namespace {

/// Twice the area inside a chain of corners; positive when it runs clockwise as seen (y down).
double twice_area(const std::vector<PathPoint>& points) {
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PathPoint a = points[i];
    const PathPoint b = points[(i + 1) % points.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area;
}

TEST(Path, ARectangleRunsClockwise) {
  Path path;
  path.add_rectangle(1, 2, 3, 4);
  const auto lines = flattened(path, 0.1);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].points, (std::vector<PathPoint>{{1, 2}, {4, 2}, {4, 6}, {1, 6}}));
  EXPECT_DOUBLE_EQ(twice_area(lines[0].points), 2 * 12);
}

TEST(Path, ACircleIsRoundAndItsPiecesStayWithinTheTolerance) {
  Path path;
  path.add_circle(10, 20, 5);
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    const auto lines = flattened(path, tolerance);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].closed);
    EXPECT_GT(twice_area(lines[0].points), 0);
    const std::vector<PathPoint>& points = lines[0].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PathPoint a = points[i];
      const PathPoint b = points[(i + 1) % points.size()];
      // Four cubics leave a circle by at most 0.03 % of its radius.
      EXPECT_NEAR(std::hypot(a.x - 10, a.y - 20), 5, 0.0003 * 5);
      EXPECT_GT(std::hypot((a.x + b.x) / 2 - 10, (a.y + b.y) / 2 - 20), 5 - tolerance - 0.0015);
    }
  }
}

TEST(Path, ARoundedRectangleKeepsItsSides) {
  Path path;
  path.add_rounded_rectangle(0, 0, 20, 10, 3);
  const PathBounds box = bounds(path);
  EXPECT_DOUBLE_EQ(box.left, 0);
  EXPECT_DOUBLE_EQ(box.top, 0);
  EXPECT_DOUBLE_EQ(box.right, 20);
  EXPECT_DOUBLE_EQ(box.bottom, 10);
  // What the four corners lose: (4 - pi) r^2.
  const auto lines = flattened(path, 1e-4);
  EXPECT_NEAR(twice_area(lines[0].points) / 2, 200 - (4 - M_PI) * 9, 0.01);
}

TEST(Path, OpenLinesStayOpenAndPathsAppend) {
  Path path;
  path.add_line(0, 0, 1, 1);
  Path both;
  both.add_rectangle(0, 0, 1, 1);
  both.append(path);
  const auto lines = flattened(both, 0.1);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_FALSE(lines[1].closed);
}

TEST(Path, APlacementMovesAndScales) {
  const Placement place{10, 20, 2.5};
  EXPECT_EQ(place.on_page({2, 4}), (PathPoint{15, 30}));
}

}  // namespace
}  // namespace tagmint::draw
