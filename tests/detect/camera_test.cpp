#include "tagmint/detect/camera.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace tagmint::detect {
namespace {

const Camera kPinhole{.fx = 800, .fy = 820, .cx = 320, .cy = 240};
const Camera kLens{.fx = 800,
                   .fy = 820,
                   .cx = 320,
                   .cy = 240,
                   .k1 = -0.25,
                   .k2 = 0.08,
                   .p1 = 0.001,
                   .p2 = -0.0005,
                   .k3 = -0.01};

TEST(Camera, PrincipalPointIsStraightAhead) {
  EXPECT_EQ(kPinhole.to_normalised({320, 240}), (Point{0, 0}));
  EXPECT_EQ(kPinhole.to_pixel({0.5, -0.25}), (Point{720, 35}));
}

TEST(Camera, DistortionFollowsTheBrownConradyFormula) {
  // By hand for (0.5, 0): r2 = 1/4; x = 0.5 (1 + k1/4 + k2/16 + k3/64) + 3 p2 / 4, y = p1 / 4.
  const Point p = kLens.to_pixel({0.5, 0});
  const double x = 0.5 * (1 - 0.25 / 4 + 0.08 / 16 - 0.01 / 64) + 0.75 * -0.0005;
  EXPECT_NEAR(p.x, 800 * x + 320, 1e-10);
  EXPECT_NEAR(p.y, 820 * 0.001 / 4 + 240, 1e-10);
}

TEST(Camera, UndistortingUndoesDistorting) {
  for (double y = -0.4; y <= 0.4; y += 0.1) {
    for (double x = -0.5; x <= 0.5; x += 0.1) {
      const Point back = kLens.to_normalised(kLens.to_pixel({x, y}));
      EXPECT_NEAR(back.x, x, 1e-10);
      EXPECT_NEAR(back.y, y, 1e-10);
    }
  }
}

TEST(Camera, ImpossibleOnesAreRefused) {
  EXPECT_NO_THROW(check_camera(kLens));
  Camera flat = kPinhole;
  flat.fx = 0;
  EXPECT_THROW(check_camera(flat), std::invalid_argument);
  Camera odd = kPinhole;
  odd.k2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_camera(odd), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::detect
