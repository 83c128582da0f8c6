#include "tagmint/detect/pose.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "pose/from_homography.h"
#include "pose/orthogonal_iteration.h"
#include "pose/pose_problem.h"
#include "pose/second_minimum.h"

namespace tagmint::detect {
namespace {

/// Two minima whose rotations differ by less (Frobenius norm, about 1.4 times the angle in rad) are
/// one minimum, reached from two sides.
constexpr double kSameRotation = 2e-3;

Pose public_pose(const PoseProblem& problem, const RigidPose& rigid) {
  Pose pose;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.R[row * 3 + column] = rigid.R(row, column);
    pose.t[row] = rigid.t(row);
  }
  pose.error = object_space_error(problem, rigid);
  return pose;
}

std::optional<Homography> tag_to_plane(const Corners& normalised, double edge_m) {
  std::array<Point, 4> tag;
  for (int i = 0; i < 4; ++i) tag[i] = edge_m / 2 * kTagCorners[i];
  return Homography::from_points(tag, normalised);
}

}  // namespace

std::optional<PoseEstimate> estimate_pose(const Corners& corners, const Camera& camera,
                                          double edge_m) {
  check_camera(camera);
  if (!std::isfinite(edge_m) || edge_m <= 0) {
    throw std::invalid_argument(
        fmt::format("a tag with an edge of {} m cannot be; it must be above 0", edge_m));
  }
  Corners normalised;
  for (int i = 0; i < 4; ++i) normalised[i] = camera.to_normalised(corners[i]);
  const std::optional<Homography> plane = tag_to_plane(normalised, edge_m);
  if (!plane) return std::nullopt;
  const std::optional<RigidPose> start = pose_from_homography(*plane);
  if (!start) return std::nullopt;

  const PoseProblem problem = square_problem(normalised, edge_m);
  const RigidPose first = orthogonal_iteration(problem, start->R);
  if (!in_front(problem, first)) return std::nullopt;
  PoseEstimate estimate{public_pose(problem, first), std::nullopt};
  if (const auto other_start = second_minimum(problem, first)) {
    const RigidPose second = orthogonal_iteration(problem, *other_start);
    if (in_front(problem, second) && (second.R - first.R).norm() > kSameRotation) {
      estimate.alternative = public_pose(problem, second);
      if (estimate.alternative->error < estimate.best.error) {
        std::swap(*estimate.alternative, estimate.best);
      }
    }
  }
  return estimate;
}

}  // namespace tagmint::detect
