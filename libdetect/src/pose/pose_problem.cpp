#include "pose/pose_problem.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

namespace tagmint::detect {

using Eigen::Matrix3d;
using Eigen::Vector3d;

PoseProblem square_problem(const Corners& normalised, double edge_m) {
  PoseProblem problem;
  for (int i = 0; i < 4; ++i) {
    problem.tag_points[i] = edge_m / 2 * Vector3d(kTagCorners[i].x, kTagCorners[i].y, 0);
    const Vector3d v(normalised[i].x, normalised[i].y, 1);
    problem.sight[i] = v * v.transpose() / v.squaredNorm();
  }
  return problem;
}

Vector3d best_translation(const PoseProblem& problem, const Matrix3d& R) {
  Matrix3d off_sight = Matrix3d::Zero();
  Vector3d pull = Vector3d::Zero();
  for (int i = 0; i < 4; ++i) {
    const Matrix3d away = Matrix3d::Identity() - problem.sight[i];
    off_sight += away;
    pull -= away * (R * problem.tag_points[i]);
  }
  // Four different lines of sight leave no direction that all of them share, so this is regular.
  return off_sight.inverse() * pull;
}

double object_space_error(const PoseProblem& problem, const RigidPose& pose) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const Vector3d q = pose.R * problem.tag_points[i] + pose.t;
    sum += (q - problem.sight[i] * q).squaredNorm();
  }
  return sum / 4;
}

bool in_front(const PoseProblem& problem, const RigidPose& pose) {
  return std::all_of(problem.tag_points.begin(), problem.tag_points.end(),
                     [&](const Vector3d& p) { return (pose.R * p + pose.t).z() > 0; });
}

Matrix3d nearest_rotation(const Matrix3d& matrix) {
  const Eigen::JacobiSVD<Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix3d V = svd.matrixV();
  Matrix3d U = svd.matrixU();
  if ((U * V.transpose()).determinant() < 0) U.col(2) *= -1;
  return U * V.transpose();
}

}  // namespace tagmint::detect
