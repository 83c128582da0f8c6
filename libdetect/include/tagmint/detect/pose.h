#pragma once

#include <array>
#include <optional>

#include "tagmint/detect/camera.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// Where a tag is, seen from the camera: point_in_camera = R * point_in_tag + t. Tag frame: origin
/// in the middle of the border square, x right, y down, z away from the viewer; R = I for a frontal
/// upright tag. Camera: x right, y down, z forward.
struct Pose {
  std::array<double, 9> R{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< rotation matrix, row-major
  std::array<double, 3> t{};                           ///< metres
  double error = 0;  ///< mean squared object-space error of the four corners, m^2 [Lu2000]
};

/// A planar target has up to two poses that explain its corners about equally well
/// [Schweighofer2006].
struct PoseEstimate {
  Pose best;                        ///< the one with the smaller error
  std::optional<Pose> alternative;  ///< the other local minimum where there is one
};

/// Pose of a square from its four corners: start from the homography, then orthogonal iteration
/// [Lu2000], then the second minimum [Schweighofer2006].
///   corners  images of kTagCorners, px
///   camera   intrinsics and distortion
///   edge_m   side of the border square, metres, > 0
///   returns  nothing when the corners are degenerate or would lie behind the camera
///   errors   std::invalid_argument for an impossible camera or edge
///   cost     about 100 iterations on four points
std::optional<PoseEstimate> estimate_pose(const Corners& corners, const Camera& camera,
                                          double edge_m);

}  // namespace tagmint::detect
