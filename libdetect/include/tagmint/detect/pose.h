#pragma once

#include <array>
#include <optional>

#include "tagmint/codec/export.h"
#include "tagmint/detect/camera.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// Covariance of a pose, row-major 6 x 6, symmetric: of a small turn in rad about the camera's x, y
/// and z axes, then of a shift in metres along them, R_true = exp([turn]) R, t_true = t + shift
/// (docs/conventions.md).
using PoseCovariance = std::array<double, 36>;

/// Where a tag is, seen from the camera: point_in_camera = R * point_in_tag + t. Tag frame: origin
/// in the middle of the border square, x right, y down, z away from the viewer; R = I for a frontal
/// upright tag. Camera: x right, y down, z forward.
struct TAGMINT_API Pose {
  std::array<double, 9> R{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< rotation matrix, row-major
  std::array<double, 3> t{};                           ///< metres
  double error = 0;  ///< mean squared object-space error of the four corners, m^2 [Lu2000]
  /// Where the corners' covariance is known: that of this pose, and the squared distance of the
  /// corners from where the pose puts them, in standard deviations. Of the right pose the latter is
  /// chi-squared with two degrees of freedom.
  std::optional<PoseCovariance> covariance = {};
  std::optional<double> chi_squared = {};
};

/// A planar target has up to two poses that explain its corners about equally well
/// [Schweighofer2006].
struct TAGMINT_API PoseEstimate {
  Pose best;                        ///< the one with the smaller error
  std::optional<Pose> alternative;  ///< the other local minimum where there is one
  /// How probable it is that the alternative is the true one, 0 .. 1/2, from the two chi-squared;
  /// nothing where the corners' covariance is not known.
  std::optional<double> alternative_probability = {};

  /// Whether the two cannot be told apart: the alternative is the true one with more than
  /// kAmbiguous. False where that is not known.
  bool ambiguous() const { return alternative_probability.value_or(0) > kAmbiguous; }
  static constexpr double kAmbiguous = 0.05;
};

/// Pose of a square from its four corners: start from the homography, then orthogonal iteration
/// [Lu2000], then the second minimum [Schweighofer2006]. With the corners' covariance both minima
/// go on to where the corners are most likely, and `best` is the likelier one.
///   corners      images of kTagCorners, px
///   camera       intrinsics and distortion
///   edge_m       side of the border square, metres, > 0
///   covariance   of the corners, Detection::corner_covariance
///   returns      nothing when the corners are degenerate or would lie behind the camera
///   errors       std::invalid_argument for an impossible camera or edge
///   cost         about 100 iterations on four points
TAGMINT_API std::optional<PoseEstimate> estimate_pose(
    const Corners& corners, const Camera& camera, double edge_m,
    const std::optional<CornerCovariance>& covariance = {});

}  // namespace tagmint::detect
