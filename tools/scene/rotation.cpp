#include "scene/rotation.h"

#include <cmath>
#include <numbers>

namespace tagmint::scene {

std::array<double, 9> multiply(const std::array<double, 9>& a, const std::array<double, 9>& b) {
  std::array<double, 9> product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) product[i * 3 + j] += a[i * 3 + k] * b[k * 3 + j];
    }
  }
  return product;
}

std::array<double, 9> rotation_from_angles(const std::array<double, 3>& degrees) {
  std::array<double, 3> c{};
  std::array<double, 3> s{};
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = std::cos(degrees[i] * std::numbers::pi / 180);
    s[i] = std::sin(degrees[i] * std::numbers::pi / 180);
  }
  const std::array<double, 9> x = {1, 0, 0, 0, c[0], -s[0], 0, s[0], c[0]};
  const std::array<double, 9> y = {c[1], 0, s[1], 0, 1, 0, -s[1], 0, c[1]};
  const std::array<double, 9> z = {c[2], -s[2], 0, s[2], c[2], 0, 0, 0, 1};
  return multiply(z, multiply(y, x));
}

}  // namespace tagmint::scene
