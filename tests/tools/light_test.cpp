#include "scene/light.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tagmint::scene {
namespace {

TEST(Shading, RunsFromFullLightToOneLessStrength) {
  GrayPlane plane(101, 51, 200.0F);
  apply_shading({.strength = 0.4, .angle_deg = 0}, plane);
  EXPECT_NEAR(plane.row(20)[0], 200 * (1 - 0.4 * 0.5 / 101), 1e-3);
  EXPECT_NEAR(plane.row(20)[50], 160, 1e-3);
  EXPECT_NEAR(plane.row(20)[100], 200 * (1 - 0.4 * 100.5 / 101), 1e-3);
  GrayPlane down(101, 51, 200.0F);
  apply_shading({.strength = 0.4, .angle_deg = 90}, down);
  EXPECT_NEAR(down.row(0)[7], 200 * (1 - 0.4 * 0.5 / 51), 1e-3);
  EXPECT_NEAR(down.row(25)[7], 160, 1e-3);
}

TEST(Shadow, LeavesItsLightInsideAndFadesByAreaOnItsEdge) {
  for (const bool reversed : {false, true}) {
    Shadow shadow{.polygon = {{10.25, -5}, {60, -5}, {60, 40}, {10.25, 40}}, .light = 0.4};
    if (reversed) std::reverse(shadow.polygon.begin(), shadow.polygon.end());
    GrayPlane plane(40, 20, 200.0F);
    apply_shadows({&shadow, 1}, plane);
    for (int y = 0; y < 20; ++y) {
      EXPECT_NEAR(plane.row(y)[9], 200, 1e-3);
      EXPECT_NEAR(plane.row(y)[10], 200 * (1 - 0.6 * 0.75), 1e-3);
      EXPECT_NEAR(plane.row(y)[11], 80, 1e-3);
      EXPECT_NEAR(plane.row(y)[39], 80, 1e-3);
    }
  }
}

TEST(Shadow, MultipliesWhereTwoOverlapAndIgnoresOneOutside) {
  const std::vector<Shadow> shadows = {
      {.polygon = {{0, 0}, {20, 0}, {20, 20}, {0, 20}}, .light = 0.5},
      {.polygon = {{10, 0}, {30, 0}, {30, 20}, {10, 20}}, .light = 0.4},
      {.polygon = {{100, 0}, {130, 0}, {130, 20}, {100, 20}}, .light = 0}};
  GrayPlane plane(40, 20, 200.0F);
  apply_shadows(shadows, plane);
  EXPECT_NEAR(plane.row(5)[5], 100, 1e-3);
  EXPECT_NEAR(plane.row(5)[15], 40, 1e-3);
  EXPECT_NEAR(plane.row(5)[25], 80, 1e-3);
  EXPECT_NEAR(plane.row(5)[35], 200, 1e-3);
}

TEST(Glare, AddsItsStrengthInTheMiddleAndFallsOffAsAGaussian) {
  const Glare spot{.centre = {20.5, 10.5}, .radius_px = 4, .strength = 100};
  GrayPlane plane(41, 21, 50.0F);
  apply_glare({&spot, 1}, plane);
  EXPECT_NEAR(plane.row(10)[20], 150, 1e-3);
  EXPECT_NEAR(plane.row(10)[24], 50 + 100 * std::exp(-0.5), 1e-3);
  EXPECT_NEAR(plane.row(14)[20], 50 + 100 * std::exp(-0.5), 1e-3);
  EXPECT_NEAR(plane.row(10)[0], 50, 1e-3);
}

TEST(Vignetting, TakesItsShareInTheCornersAndNothingInTheMiddle) {
  GrayPlane plane(81, 61, 200.0F);
  apply_vignetting(0.3, plane);
  EXPECT_NEAR(plane.row(30)[40], 200, 1e-3);
  // The corner pixel's centre is half a pixel inside.
  const double share = (40.0 * 40 + 30.0 * 30) / (40.5 * 40.5 + 30.5 * 30.5);
  for (const int x : {0, 80}) {
    for (const int y : {0, 60}) EXPECT_NEAR(plane.row(y)[x], 200 * (1 - 0.3 * share), 1e-3);
  }
}

}  // namespace
}  // namespace tagmint::scene
