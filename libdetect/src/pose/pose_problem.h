#pragma once

#include <Eigen/Core>
#include <array>

#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// point_in_camera = R * point_in_tag + t.
struct RigidPose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
};

/// Four points of a tag and the lines of sight on which they were seen.
struct PoseProblem {
  std::array<Eigen::Vector3d, 4> tag_points;  ///< metres, z = 0
  /// Projections onto the lines of sight, V = v v^T / (v^T v) with v = (x, y, 1) in the normalised
  /// image plane: V q is the point of the line of sight that is nearest to q.
  std::array<Eigen::Matrix3d, 4> sight;
};

/// The square of side `edge_m` seen with its corners (kTagCorners) at `normalised`.
PoseProblem square_problem(const Corners& normalised, double edge_m);

/// The translation of least object-space error for a given rotation [Lu2000, eq. 20]. Linear in R.
Eigen::Vector3d best_translation(const PoseProblem& problem, const Eigen::Matrix3d& R);

/// Mean squared distance of the tag points from their lines of sight, m^2 [Lu2000, eq. 19].
double object_space_error(const PoseProblem& problem, const RigidPose& pose);

/// Whether all tag points lie in front of the camera.
bool in_front(const PoseProblem& problem, const RigidPose& pose);

/// The rotation nearest to `matrix` in the sense of least squares; determinant +1.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

}  // namespace tagmint::detect
