#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace tagmint::testing {

/// Numbers that are the same on every machine and standard library: SplitMix64 [Steele2014] and our
/// own mapping to ranges.
class FixedRandom {
 public:
  explicit FixedRandom(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// A whole number in [low, high].
  int between(int low, int high) {
    return low + static_cast<int>(bits() % (static_cast<std::uint64_t>(high - low) + 1));
  }
  /// A number in [low, high).
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// Normal with mean 0 and standard deviation 1: Box and Muller's transform, one of the pair.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - real(0, 1)));
    return radius * std::cos(2 * std::numbers::pi * real(0, 1));
  }

 private:
  std::uint64_t state_;
};

}  // namespace tagmint::testing
