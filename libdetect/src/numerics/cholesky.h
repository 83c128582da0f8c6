#pragma once

#include <array>
#include <cmath>

namespace tagmint::detect {

/// L of a positive definite matrix A = L L^T, for small systems that are solved for every tag.
template <int kSize>
class Cholesky {
 public:
  using Matrix = std::array<std::array<double, kSize>, kSize>;
  using Vector = std::array<double, kSize>;

  /// Factors `upper`, of which the upper triangle (row <= column) is read; false when it is not
  /// positive definite.
  ///   cost   kSize^3 / 6 products
  bool factor(const Matrix& upper) {
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j <= i; ++j) {
        double sum = upper[j][i];
        for (int k = 0; k < j; ++k) sum -= lower_[i][k] * lower_[j][k];
        if (j < i) {
          lower_[i][j] = sum * inverse_diagonal_[j];
        } else if (!(sum > 0)) {
          return false;
        } else {
          inverse_diagonal_[i] = 1 / std::sqrt(sum);
          lower_[i][i] = sum * inverse_diagonal_[i];
        }
      }
    }
    return true;
  }

  /// x with L x = b.
  Vector solve_lower(Vector b) const {
    for (int i = 0; i < kSize; ++i) {
      for (int k = 0; k < i; ++k) b[i] -= lower_[i][k] * b[k];
      b[i] *= inverse_diagonal_[i];
    }
    return b;
  }

  /// x with A x = b.
  Vector solve(const Vector& b) const {
    Vector x = solve_lower(b);
    for (int i = kSize - 1; i >= 0; --i) {
      for (int k = i + 1; k < kSize; ++k) x[i] -= lower_[k][i] * x[k];
      x[i] *= inverse_diagonal_[i];
    }
    return x;
  }

 private:
  Matrix lower_{};
  Vector inverse_diagonal_{};
};

}  // namespace tagmint::detect
