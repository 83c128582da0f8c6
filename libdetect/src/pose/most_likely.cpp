#include "pose/most_likely.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tagmint::detect {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix86 = Eigen::Matrix<double, 8, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector8 = Eigen::Matrix<double, 8, 1>;

constexpr int kMaxSteps = 30;
/// A step ends the search when it lowers chi squared by less.
constexpr double kSettled = 1e-9;
constexpr double kFirstDamping = 1e-3;
constexpr double kMostDamping = 1e9;

Vector3d tag_point(int corner, double edge_m) {
  return edge_m / 2 * Vector3d(kTagCorners[corner].x, kTagCorners[corner].y, 0);
}

/// Seen less predicted; nothing when a corner is not in front of the camera.
std::optional<Vector8> residuals(const SeenCorners& seen, double edge_m, const RigidPose& pose) {
  Vector8 r;
  for (int i = 0; i < 4; ++i) {
    const Vector3d q = pose.R * tag_point(i, edge_m) + pose.t;
    if (!(q.z() > 0)) return std::nullopt;
    r(2 * i) = seen.normalised[i].x - q.x() / q.z();
    r(2 * i + 1) = seen.normalised[i].y - q.y() / q.z();
  }
  return r;
}

/// d predicted / d (turn, shift).
Matrix86 jacobian(double edge_m, const RigidPose& pose) {
  Matrix86 J;
  for (int i = 0; i < 4; ++i) {
    const Vector3d p = pose.R * tag_point(i, edge_m);
    const Vector3d q = p + pose.t;
    Eigen::Matrix<double, 2, 3> by_point;
    by_point << 1 / q.z(), 0, -q.x() / (q.z() * q.z()), 0, 1 / q.z(), -q.y() / (q.z() * q.z());
    Matrix3d by_turn;  // turn x p
    by_turn << 0, p.z(), -p.y(), -p.z(), 0, p.x(), p.y(), -p.x(), 0;
    J.block<2, 3>(2 * i, 0) = by_point * by_turn;
    J.block<2, 3>(2 * i, 3) = by_point;
  }
  return J;
}

RigidPose moved(const RigidPose& pose, const Vector6& step) {
  const Vector3d turn = step.head<3>();
  const double angle = turn.norm();
  RigidPose next = pose;
  if (angle > 0) next.R = Eigen::AngleAxisd(angle, turn / angle) * pose.R;
  next.t += step.tail<3>();
  return next;
}

}  // namespace

std::optional<SeenCorners> seen_corners(const Corners& normalised,
                                        const CornerCovariance& covariance, const Camera& camera) {
  Matrix8 to_plane = Matrix8::Zero();
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 4; ++i) {
    const Point n = normalised[i];
    const Point dx = camera.to_pixel(n + Point{kStep, 0}) - camera.to_pixel(n - Point{kStep, 0});
    const Point dy = camera.to_pixel(n + Point{0, kStep}) - camera.to_pixel(n - Point{0, kStep});
    Eigen::Matrix2d to_pixel;
    to_pixel << dx.x, dy.x, dx.y, dy.y;
    to_plane.block<2, 2>(2 * i, 2 * i) = (to_pixel / (2 * kStep)).inverse();
  }
  const Matrix8 in_px =
      Eigen::Map<const Eigen::Matrix<double, 8, 8, Eigen::RowMajor>>(covariance.data());
  const Matrix8 on_plane = to_plane * in_px * to_plane.transpose();
  const Eigen::LLT<Matrix8> factor(on_plane);
  if (factor.info() != Eigen::Success) return std::nullopt;
  return SeenCorners{normalised, factor.solve(Matrix8::Identity())};
}

std::optional<LikelyPose> most_likely_pose(const SeenCorners& seen, double edge_m,
                                           const RigidPose& start) {
  LikelyPose found{start, 0, {}};
  std::optional<Vector8> r = residuals(seen, edge_m, start);
  if (!r) return std::nullopt;
  found.chi_squared = r->dot(seen.information * *r);
  double damping = kFirstDamping;
  for (int step = 0; step < kMaxSteps && damping < kMostDamping; ++step) {
    const Matrix86 J = jacobian(edge_m, found.pose);
    const Matrix6 normal = J.transpose() * seen.information * J;
    const Vector6 gradient = J.transpose() * (seen.information * *r);
    Matrix6 damped = normal;
    damped.diagonal() *= 1 + damping;
    const RigidPose next = moved(found.pose, damped.ldlt().solve(gradient));
    const std::optional<Vector8> next_r = residuals(seen, edge_m, next);
    const double chi_squared = next_r ? next_r->dot(seen.information * *next_r) : 0;
    if (!next_r || !(chi_squared <= found.chi_squared)) {
      damping *= 10;
      continue;
    }
    const double gain = found.chi_squared - chi_squared;
    found.pose = next;
    found.chi_squared = chi_squared;
    r = next_r;
    damping /= 10;
    if (gain < kSettled * (1 + chi_squared)) break;
  }
  found.pose.R = nearest_rotation(found.pose.R);
  const Matrix86 J = jacobian(edge_m, found.pose);
  const Eigen::LLT<Matrix6> factor(J.transpose() * seen.information * J);
  if (factor.info() != Eigen::Success) return std::nullopt;
  found.covariance = factor.solve(Matrix6::Identity());
  return found;
}

}  // namespace tagmint::detect
