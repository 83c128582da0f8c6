#include "pose/orthogonal_iteration.h"

namespace tagmint::detect {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// One step: absolute orientation of the tag to the points of sight nearest to it.
Matrix3d next_rotation(const PoseProblem& problem, const RigidPose& pose) {
  std::array<Vector3d, 4> seen;
  Vector3d tag_mean = Vector3d::Zero();
  Vector3d seen_mean = Vector3d::Zero();
  for (int i = 0; i < 4; ++i) {
    seen[i] = problem.sight[i] * (pose.R * problem.tag_points[i] + pose.t);
    seen_mean += seen[i] / 4;
    tag_mean += problem.tag_points[i] / 4;
  }
  Matrix3d correlation = Matrix3d::Zero();
  for (int i = 0; i < 4; ++i) {
    correlation += (seen[i] - seen_mean) * (problem.tag_points[i] - tag_mean).transpose();
  }
  return nearest_rotation(correlation);
}

}  // namespace

RigidPose orthogonal_iteration(const PoseProblem& problem, const Matrix3d& start) {
  constexpr double kConverged = 1e-10;
  RigidPose pose{start, best_translation(problem, start)};
  for (int i = 0; i < kMaxIterations; ++i) {
    const Matrix3d R = next_rotation(problem, pose);
    const double turned = (R - pose.R).norm();
    pose = {R, best_translation(problem, R)};
    if (turned < kConverged) break;
  }
  return pose;
}

}  // namespace tagmint::detect
