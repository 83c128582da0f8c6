#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace tagmint::scene {

/// The finaliser of SplitMix64 [Steele2014]: a bijection of 64-bit words in which every input bit
/// changes about half of the output bits.
constexpr std::uint64_t mix_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Random word number `index` of the stream `seed`. A pure function, so that what is drawn at a
/// place does not depend on the order or the threads in which places are visited.
constexpr std::uint64_t random_word(std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
  return mix_bits(mix_bits(seed + kGolden) + (index + 1) * kGolden);
}

/// The upper 53 bits as a number in [0, 1).
constexpr double unit_interval(std::uint64_t word) {
  return static_cast<double>(word >> 11) * 0x1p-53;
}

/// A standard normal number from one random word, by the polar angle and radius of Box and Muller.
inline double standard_normal(std::uint64_t word) {
  const double u = (static_cast<double>(word >> 32) + 0.5) * 0x1p-32;  // in (0, 1)
  const double v = static_cast<double>(word & 0xffffffffu) * 0x1p-32;
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

/// A stream of random numbers with our own mapping to ranges, the same on every machine.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t word() { return random_word(seed_, index_++); }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * unit_interval(word()); }
  /// Uniform in 0 .. count - 1; the bias is below count / 2^53.
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(unit_interval(word()) * static_cast<double>(count));
  }

 private:
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

}  // namespace tagmint::scene
