#pragma once

#include "pose/pose_problem.h"

namespace tagmint::detect {

/// The local minimum of the object-space error that is reached from a rotation: in turns, the best
/// translation, the points' nearest places on their lines of sight, and the rotation that fits the
/// tag to those places best. The error never grows.
///   start    rotation to begin with
///   returns  the pose when a step turns it by less than 1e-10 rad, or after kMaxIterations
///   cost     one 3 x 3 singular value decomposition a step, 20 to 100 steps from a homography
///   source   [Lu2000, section 3]
RigidPose orthogonal_iteration(const PoseProblem& problem, const Eigen::Matrix3d& start);

inline constexpr int kMaxIterations = 1000;

}  // namespace tagmint::detect
