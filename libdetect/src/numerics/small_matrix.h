#pragma once

#include <array>
#include <optional>

namespace tagmint::detect {

/// 3 x 3 matrices, row-major, and columns of three; just what homographies and planes need.
using Matrix3 = std::array<double, 9>;
using Vector3 = std::array<double, 3>;

Matrix3 multiply(const Matrix3& a, const Matrix3& b);
Vector3 multiply(const Matrix3& a, const Vector3& v);
double determinant(const Matrix3& a);
/// Transposed cofactors: a * adjugate(a) = determinant(a) * identity. Exists for any matrix.
Matrix3 adjugate(const Matrix3& a);

/// Nothing when `a` is singular to working precision: |det| at most 1e-14 times the product of the
/// lengths of its rows (Hadamard's bound on |det|), so the answer does not depend on the scale.
std::optional<Matrix3> inverse(const Matrix3& a);

/// x with a * x = b; nothing when `a` is singular in the sense of inverse().
std::optional<Vector3> solve(const Matrix3& a, const Vector3& b);

}  // namespace tagmint::detect
