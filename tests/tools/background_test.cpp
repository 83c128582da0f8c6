#include "scene/background.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tagmint::scene {
namespace {

TEST(Background, GradientMeetsItsEnds) {
  const GrayPlane plane =
      draw_background(GradientBackground{.from = 50, .to = 150, .angle_deg = 180}, 100, 10, 1);
  EXPECT_NEAR(plane.row(3)[0], 149.5, 1e-3);
  EXPECT_NEAR(plane.row(3)[99], 50.5, 1e-3);
}

TEST(Background, TextureStaysWithinItsAmplitudeAndFollowsTheSeed) {
  const TextureBackground texture{.gray = 120, .amplitude = 30, .scale_px = 16};
  const GrayPlane first = draw_background(texture, 160, 120, 1);
  EXPECT_EQ(first.levels, draw_background(texture, 160, 120, 1).levels);
  EXPECT_NE(first.levels, draw_background(texture, 160, 120, 2).levels);
  float lowest = 255;
  float highest = 0;
  for (const float level : first.levels) {
    lowest = std::min(lowest, level);
    highest = std::max(highest, level);
  }
  EXPECT_GE(lowest, 90);
  EXPECT_LE(highest, 150);
  EXPECT_GT(highest - lowest, 20);
}

TEST(Background, PhotographOfTheSameSizeIsKeptPixelByPixel) {
  PhotoBackground photo;
  photo.image = detect::Image(9, 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) photo.image.at(x, y) = static_cast<std::uint8_t>(x * 20 + y);
  }
  const GrayPlane plane = draw_background(photo, 9, 7, 1);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) EXPECT_NEAR(plane.row(y)[x], photo.image.at(x, y), 1e-3);
  }
}

TEST(Background, PhotographIsScaledToCoverAndCutEvenly) {
  // Three upright stripes; a square cut from the middle of a picture twice as wide as high.
  PhotoBackground photo;
  photo.image = detect::Image(80, 40, 10);
  for (int y = 0; y < 40; ++y) {
    for (int x = 20; x < 60; ++x) photo.image.at(x, y) = 210;
  }
  const GrayPlane plane = draw_background(photo, 20, 20, 1);
  for (int x = 1; x < 19; ++x) EXPECT_NEAR(plane.row(10)[x], 210, 1e-3) << x;
}

}  // namespace
}  // namespace tagmint::scene
