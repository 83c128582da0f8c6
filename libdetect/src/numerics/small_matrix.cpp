#include "numerics/small_matrix.h"

#include <cmath>

namespace tagmint::detect {
namespace {

constexpr double kSingular = 1e-14;

double row_length(const Matrix3& a, int row) {
  return std::hypot(a[row * 3], a[row * 3 + 1], a[row * 3 + 2]);
}

}  // namespace

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  Matrix3 product{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) product[i * 3 + j] += a[i * 3 + k] * b[k * 3 + j];
    }
  }
  return product;
}

Vector3 multiply(const Matrix3& a, const Vector3& v) {
  Vector3 product{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) product[i] += a[i * 3 + k] * v[k];
  }
  return product;
}

double determinant(const Matrix3& a) {
  return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
         a[2] * (a[3] * a[7] - a[4] * a[6]);
}

Matrix3 adjugate(const Matrix3& a) {
  return {a[4] * a[8] - a[5] * a[7], a[2] * a[7] - a[1] * a[8], a[1] * a[5] - a[2] * a[4],
          a[5] * a[6] - a[3] * a[8], a[0] * a[8] - a[2] * a[6], a[2] * a[3] - a[0] * a[5],
          a[3] * a[7] - a[4] * a[6], a[1] * a[6] - a[0] * a[7], a[0] * a[4] - a[1] * a[3]};
}

std::optional<Matrix3> inverse(const Matrix3& a) {
  const double det = determinant(a);
  const double bound = row_length(a, 0) * row_length(a, 1) * row_length(a, 2);
  if (!(std::abs(det) > kSingular * bound)) return std::nullopt;
  Matrix3 inverse = adjugate(a);
  for (double& value : inverse) value /= det;
  return inverse;
}

std::optional<Vector3> solve(const Matrix3& a, const Vector3& b) {
  const std::optional<Matrix3> inverted = inverse(a);
  if (!inverted) return std::nullopt;
  return multiply(*inverted, b);
}

}  // namespace tagmint::detect
