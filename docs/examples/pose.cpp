// docs/examples/pose.cpp: where a tag is, from the corners of its border square.
#include "tagmint/detect/pose.h"

#include <iostream>

#include "tagmint/detect/camera.h"

namespace detect = tagmint::detect;

int main() {
  // A principal point that OpenCV has calibrated needs 0.5 added, see docs/conventions.md.
  const detect::Camera camera{.fx = 600, .fy = 600, .cx = 320, .cy = 240, .k1 = -0.1};
  // As Detection::corners has them: bottom left first, counter-clockwise as seen.
  const detect::Corners corners = {{{300, 280}, {390, 285}, {388, 195}, {302, 200}}};
  constexpr double kEdge_m = 0.1;  // side of the border square

  const auto estimate = detect::estimate_pose(corners, camera, kEdge_m);
  if (!estimate) {
    std::cout << "no pose explains these corners\n";
    return 1;
  }
  const auto tell = [](const char* which, const detect::Pose& pose) {
    std::cout.precision(3);
    std::cout << which << ": " << pose.t[0] << ' ' << pose.t[1] << ' ' << pose.t[2]
              << " m, faces along " << pose.R[2] << ' ' << pose.R[5] << ' ' << pose.R[8] << '\n';
  };
  tell("best", estimate->best);
  // A small or distant tag may be seen from two sides alike.
  if (estimate->alternative) tell("or", *estimate->alternative);
}
