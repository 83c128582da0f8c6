#include "tagmint/detect/pose.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "pose/from_homography.h"
#include "pose/most_likely.h"
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

/// The pose that the corners' covariance makes most likely, from a minimum of the object-space
/// error; that minimum itself where the covariance is not known or leads nowhere.
Pose finished_pose(const PoseProblem& problem, const RigidPose& minimum,
                   const std::optional<SeenCorners>& seen, double edge_m) {
  if (seen) {
    if (const auto likely = most_likely_pose(*seen, edge_m, minimum)) {
      Pose pose = public_pose(problem, likely->pose);
      pose.chi_squared = likely->chi_squared;
      PoseCovariance covariance;
      for (int i = 0; i < 36; ++i) covariance[i] = likely->covariance(i / 6, i % 6);
      pose.covariance = covariance;
      return pose;
    }
  }
  return public_pose(problem, minimum);
}

double rotation_distance(const Pose& a, const Pose& b) {
  double sum = 0;
  for (int i = 0; i < 9; ++i) sum += (a.R[i] - b.R[i]) * (a.R[i] - b.R[i]);
  return std::sqrt(sum);
}

/// Puts the likelier of the two first, by chi-squared where both have one, else by the error.
void rank(PoseEstimate& estimate) {
  Pose& best = estimate.best;
  Pose& other = *estimate.alternative;
  const bool weighed = best.chi_squared && other.chi_squared;
  if (weighed ? *other.chi_squared < *best.chi_squared : other.error < best.error) {
    std::swap(best, other);
  }
  if (weighed) {
    // Both were equally probable before they were seen.
    const double odds = std::exp((*best.chi_squared - *other.chi_squared) / 2);
    estimate.alternative_probability = odds / (1 + odds);
  }
}

}  // namespace

std::optional<PoseEstimate> estimate_pose(const Corners& corners, const Camera& camera,
                                          double edge_m,
                                          const std::optional<CornerCovariance>& covariance) {
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
  std::optional<SeenCorners> seen;
  if (covariance) seen = seen_corners(normalised, *covariance, camera);
  PoseEstimate estimate{finished_pose(problem, first, seen, edge_m), std::nullopt};
  if (covariance && estimate.best.covariance) estimate.alternative_probability = 0;
  if (const auto other_start = second_minimum(problem, first)) {
    const RigidPose second = orthogonal_iteration(problem, *other_start);
    if (in_front(problem, second) && (second.R - first.R).norm() > kSameRotation) {
      const Pose other = finished_pose(problem, second, seen, edge_m);
      if (rotation_distance(other, estimate.best) > kSameRotation) {
        estimate.alternative = other;
        rank(estimate);
      }
    }
  }
  return estimate;
}

}  // namespace tagmint::detect
