#pragma once

#include <Eigen/Core>
#include <optional>

#include "pose/pose_problem.h"
#include "tagmint/detect/camera.h"
#include "tagmint/detect/detection.h"

namespace tagmint::detect {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// The corners on the normalised image plane and their covariance there.
struct SeenCorners {
  Corners normalised;
  Matrix8 information;  ///< inverse of the covariance
};

/// Corners taken through the camera, their covariance to first order; nothing where the covariance
/// is not positive definite.
///   normalised   the corners on the normalised image plane
///   covariance   of the corners in the image, px^2
std::optional<SeenCorners> seen_corners(const Corners& normalised,
                                        const CornerCovariance& covariance, const Camera& camera);

/// The pose that explains corners best, weighed by their covariance.
struct LikelyPose {
  RigidPose pose;
  /// Squared distance of the corners from where they should be, in standard deviations: of a right
  /// pose chi-squared with two degrees of freedom (eight coordinates less six parameters).
  double chi_squared = 0;
  /// Of a turn (rad) and a shift (m), both along the camera's axes: R = exp([turn]) R_found,
  /// t = t_found + shift.
  Matrix6 covariance;
};

/// The minimum of the corners' weighted squared reprojection error that is reached from `start`:
/// Levenberg's steps, which never let it grow.
///   edge_m    side of the border square
///   returns   nothing when a corner comes to lie behind the camera, or the tag is seen so badly
///   that
///             some direction of the pose is not determined
///   cost      some microseconds
std::optional<LikelyPose> most_likely_pose(const SeenCorners& seen, double edge_m,
                                           const RigidPose& start);

}  // namespace tagmint::detect
