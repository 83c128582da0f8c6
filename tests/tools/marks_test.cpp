#include "scene/marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/clutter.h"

namespace tagmint::scene {
namespace {

/// What is missing from a white picture, in pixels of black.
double ink_px(const GrayPlane& plane) {
  double ink = 0;
  for (const float level : plane.levels) ink += (200 - level) / 200;
  return ink;
}

Window whole(const GrayPlane& plane) { return Window::whole(plane.width, plane.height); }

GrayPlane clutter_picture(const ClutterBackground& clutter, int width, int height,
                          std::uint64_t seed) {
  GrayPlane plane(width, height);
  paint(clutter_patches(clutter, width, height, seed), whole(plane), plane);
  return plane;
}

TEST(Marks, ASpeckIsADiscOfItsWidth) {
  const Mark speck{.path = {{20.3, 15.7}}, .width_px = 9, .gray = 0};
  GrayPlane plane(40, 30, 200.0F);
  paint(mark_patches({&speck, 1}), whole(plane), plane);
  EXPECT_NEAR(ink_px(plane), std::numbers::pi * 4.5 * 4.5, 0.3);  // a polygon of 48 corners
  EXPECT_NEAR(plane.row(15)[20], 0, 1e-3);
  EXPECT_NEAR(plane.row(15)[25], 200, 1e-3);
}

TEST(Marks, AStrokeIsAStripWithRoundEnds) {
  for (const bool backwards : {false, true}) {
    Mark stroke{.path = {{10, 10}, {40, 50}}, .width_px = 4, .gray = 0};
    if (backwards) std::swap(stroke.path[0], stroke.path[1]);
    GrayPlane plane(60, 60, 200.0F);
    paint(mark_patches({&stroke, 1}), whole(plane), plane);
    EXPECT_NEAR(ink_px(plane), 50 * 4 + std::numbers::pi * 4, 0.1);
    EXPECT_NEAR(plane.row(30)[25], 0, 1e-3);
    EXPECT_NEAR(plane.row(36)[22], 200, 1e-3);
  }
}

TEST(Marks, APathGoesThroughAllItsPointsInItsGray) {
  const Mark path{.path = {{5, 5}, {35, 5}, {35, 35}}, .width_px = 4, .gray = 90};
  GrayPlane plane(40, 40, 200.0F);
  paint(mark_patches({&path, 1}), whole(plane), plane);
  EXPECT_NEAR(plane.row(5)[20], 90, 1e-3);
  EXPECT_NEAR(plane.row(5)[34], 90, 1e-3);
  EXPECT_NEAR(plane.row(20)[35], 90, 1e-3);
  EXPECT_NEAR(plane.row(20)[20], 200, 1e-3);
}

TEST(Marks, OutsideThePictureDoNothing) {
  const Mark far{.path = {{-100, -100}, {-90, 300}}, .width_px = 4};
  GrayPlane plane(40, 40, 200.0F);
  paint(mark_patches({&far, 1}), whole(plane), plane);
  EXPECT_EQ(plane.levels, GrayPlane(40, 40, 200.0F).levels);
}

TEST(Clutter, FollowsTheSeedAloneAndStaysWithinGrayLevels) {
  const GrayPlane first = clutter_picture({}, 160, 120, 1);
  EXPECT_EQ(first.levels, clutter_picture({}, 160, 120, 1).levels);
  EXPECT_NE(first.levels, clutter_picture({}, 160, 120, 2).levels);
  for (const float level : first.levels) {
    EXPECT_GE(level, 0);
    EXPECT_LE(level, 255);
  }
}

TEST(Clutter, HasEdgesOfEveryDirection) {
  const GrayPlane plane = clutter_picture({.shapes = 800}, 320, 240, 3);
  std::array<int, 4> by_direction{};  // across, falling, down, rising
  for (int y = 1; y < 239; ++y) {
    for (int x = 1; x < 319; ++x) {
      const double gx = plane.row(y)[x + 1] - plane.row(y)[x - 1];
      const double gy = plane.row(y + 1)[x] - plane.row(y - 1)[x];
      if (std::hypot(gx, gy) < 20) continue;
      const double turns = std::atan2(gy, gx) / (std::numbers::pi / 4);
      ++by_direction[static_cast<std::size_t>(std::lround(turns) + 8) % 4];
    }
  }
  for (const int edges : by_direction) EXPECT_GT(edges, 500);
}

}  // namespace
}  // namespace tagmint::scene
