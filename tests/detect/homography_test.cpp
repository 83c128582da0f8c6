#include "tagmint/detect/homography.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fixed_random.h"

namespace tagmint::detect {
namespace {

void expect_near(Point a, Point b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(Homography, TakesEachPointToItsPartner) {
  testing::FixedRandom random(1);
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Point, 4> from, to;
    for (int i = 0; i < 4; ++i) {
      from[i] = kTagCorners[i] + Point{random.real(-0.4, 0.4), random.real(-0.4, 0.4)};
      to[i] =
          Point{3000, 2000} + 25.0 * kTagCorners[i] + Point{random.real(-9, 9), random.real(-9, 9)};
    }
    const auto h = Homography::from_points(from, to);
    ASSERT_TRUE(h);
    for (int i = 0; i < 4; ++i) expect_near(h->project(from[i]), to[i], 1e-8);
    EXPECT_DOUBLE_EQ((*h)(2, 2), 1.0);
  }
}

TEST(Homography, RecoversAKnownProjectiveMap) {
  const Homography truth({31, -4, 320, 6, 28, 240, 0.05, -0.02, 1});
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = truth.project(kTagCorners[i]);
  const auto found = Homography::from_corners(corners);
  ASSERT_TRUE(found);
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(found->row_major()[i], truth.row_major()[i], 1e-10);
}

TEST(Homography, ThreePointsOnALineGiveNone) {
  EXPECT_FALSE(Homography::from_corners({{{0, 0}, {1, 0}, {2, 0}, {0, 5}}}));
  EXPECT_FALSE(Homography::from_corners({{{3, 3}, {3, 3}, {9, 8}, {0, 5}}}));
  EXPECT_FALSE(Homography::from_corners({{{3, 3}, {3, 3}, {3, 3}, {3, 3}}}));
}

TEST(Homography, InverseLeadsBack) {
  const Homography h({31, -4, 320, 6, 28, 240, 0.05, -0.02, 1});
  const auto back = h.inverse();
  ASSERT_TRUE(back);
  expect_near(back->project(h.project({0.3, -0.7})), {0.3, -0.7}, 1e-12);
  EXPECT_FALSE(Homography({1, 2, 3, 2, 4, 6, 0, 0, 1}).inverse());
}

TEST(Homography, RotatedTurnsTheTagClockwiseFirst) {
  const Homography h({31, -4, 320, 6, 28, 240, 0.05, -0.02, 1});
  expect_near(h.rotated(1).project({0.25, 0.5}), h.project({-0.5, 0.25}), 1e-12);
  expect_near(h.rotated(2).project({0.25, 0.5}), h.project({-0.25, -0.5}), 1e-12);
  expect_near(h.rotated(-1).project({0.25, 0.5}), h.project({0.5, -0.25}), 1e-12);
  EXPECT_EQ(h.rotated(4), h);
}

}  // namespace
}  // namespace tagmint::detect
