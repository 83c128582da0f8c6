#include "scene/light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tagmint::scene {
namespace {

TEST(Shading, RunsFromFullLightToOneLessStrength) {
  GrayPlane plane(101, 51, 200.0F);
  apply_shading({.strength = 0.4, .angle_deg = 0}, Window::whole(101, 51), plane);
  EXPECT_NEAR(plane.row(20)[0], 200 * (1 - 0.4 * 0.5 / 101), 1e-3);
  EXPECT_NEAR(plane.row(20)[50], 160, 1e-3);
  EXPECT_NEAR(plane.row(20)[100], 200 * (1 - 0.4 * 100.5 / 101), 1e-3);
  GrayPlane down(101, 51, 200.0F);
  apply_shading({.strength = 0.4, .angle_deg = 90}, Window::whole(101, 51), down);
  EXPECT_NEAR(down.row(0)[7], 200 * (1 - 0.4 * 0.5 / 51), 1e-3);
  EXPECT_NEAR(down.row(25)[7], 160, 1e-3);
}

TEST(Shadow, LeavesItsLightInsideAndFadesByAreaOnItsEdge) {
  for (const bool reversed : {false, true}) {
    Shadow shadow{.polygon = {{10.25, -5}, {60, -5}, {60, 40}, {10.25, 40}}, .light = 0.4};
    if (reversed) std::reverse(shadow.polygon.begin(), shadow.polygon.end());
    GrayPlane plane(40, 20, 200.0F);
    apply_shadows({&shadow, 1}, Window::whole(40, 20), plane);
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
  apply_shadows(shadows, Window::whole(40, 20), plane);
  EXPECT_NEAR(plane.row(5)[5], 100, 1e-3);
  EXPECT_NEAR(plane.row(5)[15], 40, 1e-3);
  EXPECT_NEAR(plane.row(5)[25], 80, 1e-3);
  EXPECT_NEAR(plane.row(5)[35], 200, 1e-3);
}

TEST(Glare, AddsItsStrengthInTheMiddleAndFallsOffAsAGaussian) {
  const Glare spot{.centre = {20.5, 10.5}, .radius_px = 4, .strength = 100};
  GrayPlane plane(41, 21, 50.0F);
  apply_glare({&spot, 1}, Window::whole(41, 21), plane);
  EXPECT_NEAR(plane.row(10)[20], 150, 1e-3);
  EXPECT_NEAR(plane.row(10)[24], 50 + 100 * std::exp(-0.5), 1e-3);
  EXPECT_NEAR(plane.row(14)[20], 50 + 100 * std::exp(-0.5), 1e-3);
  EXPECT_NEAR(plane.row(10)[0], 50, 1e-3);
}

TEST(Vignetting, TakesItsShareInTheCornersAndNothingInTheMiddle) {
  GrayPlane plane(81, 61, 200.0F);
  apply_vignetting(0.3, Window::whole(81, 61), plane);
  EXPECT_NEAR(plane.row(30)[40], 200, 1e-3);
  // The corner pixel's centre is half a pixel inside.
  const double share = (40.0 * 40 + 30.0 * 30) / (40.5 * 40.5 + 30.5 * 30.5);
  for (const int x : {0, 80}) {
    for (const int y : {0, 60}) EXPECT_NEAR(plane.row(y)[x], 200 * (1 - 0.3 * share), 1e-3);
  }
}

TEST(Light, OfAFineWindowHasTheMeansOfItsPixels) {
  const Window whole = Window::whole(40, 30);
  const Window fine{.width = 40, .height = 30, .scale = 4, .first_row = 40, .rows = 40};
  const std::vector<Shadow> shadows = {{.polygon = {{3, 2}, {31, 9}, {11, 28}}, .light = 0.3}};
  const std::vector<Glare> glare = {{.centre = {20, 15}, .radius_px = 9, .strength = 60}};
  const auto lit = [&](const Window& window) {
    GrayPlane plane(window.columns(), window.rows, 150.0F);
    apply_shading({.strength = 0.4, .angle_deg = 30}, window, plane);
    apply_shadows(shadows, window, plane);
    apply_glare(glare, window, plane);
    apply_vignetting(0.5, window, plane);
    return plane;
  };
  const GrayPlane coarse = lit(whole), samples = lit(fine);
  for (int y = 10; y < 20; ++y) {
    for (int x = 0; x < 40; ++x) {
      double sum = 0;
      for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) sum += samples.row((y - 10) * 4 + j)[x * 4 + i];
      }
      // Light that is even within a sample is not quite even within a pixel.
      EXPECT_NEAR(sum / 16, coarse.row(y)[x], 0.25) << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace tagmint::scene
