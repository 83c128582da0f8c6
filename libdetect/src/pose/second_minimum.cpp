#include "pose/second_minimum.h"

#include <Eigen/Geometry>
#include <cmath>

#include "numerics/polynomial_roots.h"

namespace tagmint::detect {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Factors of R = turn(gamma) lean(beta) turn(alpha): turns about the line of sight z, lean about
/// y.
struct LeanFactors {
  Matrix3d turn_after;   // about z by gamma
  Matrix3d turn_before;  // about z by alpha
  double half_tangent;   // tan(beta / 2), 0 <= beta <= pi
};

LeanFactors factor(const Matrix3d& R) {
  const double sine = std::hypot(R(0, 2), R(1, 2));
  const double beta = std::atan2(sine, R(2, 2));
  // Of a tag that faces the camera the direction of its lean is arbitrary.
  const double gamma = sine > 0 ? std::atan2(R(1, 2), R(0, 2)) : 0.0;
  const AngleAxisd turn(gamma, Vector3d::UnitZ());
  const Matrix3d rest = AngleAxisd(-beta, Vector3d::UnitY()) *
                        AngleAxisd(-gamma, Vector3d::UnitZ()).toRotationMatrix() * R;
  return {turn.toRotationMatrix(), rest, std::tan(beta / 2)};
}

Matrix3d lean(double half_tangent) {
  return AngleAxisd(2 * std::atan(half_tangent), Vector3d::UnitY()).toRotationMatrix();
}

/// (1 + b^2) lean(b) = terms[0] + terms[1] b + terms[2] b^2, by the half-angle formulas.
std::array<Matrix3d, 3> lean_terms() {
  std::array<Matrix3d, 3> terms;
  terms[0] = Matrix3d::Identity();
  terms[1] << 0, 0, 2, 0, 0, 0, -2, 0, 0;
  terms[2] << -1, 0, 0, 0, 1, 0, 0, 0, -1;
  return terms;
}

/// Coefficients n of the error along the family, times (1 + b^2)^2: n[0] + n[1] b + ... + n[4] b^4.
/// Residuals with the best translation are linear in the rotation, hence quadratic in b.
std::array<double, 5> error_numerator(const PoseProblem& problem, const Matrix3d& to_sight,
                                      const LeanFactors& factors) {
  std::array<std::array<Vector3d, 4>, 3> residual;  // by power of b, then by point
  const std::array<Matrix3d, 3> terms = lean_terms();
  for (int power = 0; power < 3; ++power) {
    const Matrix3d part =
        to_sight.transpose() * factors.turn_after * terms[power] * factors.turn_before;
    const Vector3d t = best_translation(problem, part);
    for (int i = 0; i < 4; ++i) {
      const Vector3d q = part * problem.tag_points[i] + t;
      residual[power][i] = q - problem.sight[i] * q;
    }
  }
  std::array<double, 5> n{};
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 4; ++i) n[j + k] += residual[j][i].dot(residual[k][i]);
    }
  }
  return n;
}

}  // namespace

std::optional<Matrix3d> second_minimum(const PoseProblem& problem, const RigidPose& first) {
  // Turn the camera so that it looks at the tag's middle.
  const Matrix3d to_sight =
      Eigen::Quaterniond::FromTwoVectors(first.t, Vector3d::UnitZ()).toRotationMatrix();
  const LeanFactors factors = factor(to_sight * first.R);
  const std::array<double, 5> n = error_numerator(problem, to_sight, factors);
  // d/db of n(b) / (1 + b^2)^2 has the sign of n'(b) (1 + b^2) - 4 b n(b), where b^5 cancels.
  const std::array<double, 5> slope = {n[1], 2 * n[2] - 4 * n[0], 3 * (n[3] - n[1]),
                                       4 * n[4] - 2 * n[2], -n[3]};
  const auto error = [&](double b) {
    const double w = 1 + b * b;
    return polynomial_at(n, b) / (w * w);
  };
  // The front shows while the lean stays below 90 degrees, |b| < 1. Minima alternate with maxima;
  // the one nearest to the first pose is that pose itself.
  std::vector<double> minima;
  const std::vector<double> changes = polynomial_sign_changes(slope, -1, 1);
  bool falling = polynomial_at(slope, -1) <= 0;
  for (const double b : changes) {
    if (falling) minima.push_back(b);
    falling = !falling;
  }
  std::optional<double> other;
  std::size_t own = 0;
  for (std::size_t i = 1; i < minima.size(); ++i) {
    if (std::abs(minima[i] - factors.half_tangent) < std::abs(minima[own] - factors.half_tangent)) {
      own = i;
    }
  }
  for (std::size_t i = 0; i < minima.size(); ++i) {
    if (i != own && (!other || error(minima[i]) < error(*other))) other = minima[i];
  }
  if (!other) return std::nullopt;
  return to_sight.transpose() * factors.turn_after * lean(*other) * factors.turn_before;
}

}  // namespace tagmint::detect
