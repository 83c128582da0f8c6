#pragma once

#include <cstdint>

namespace tagmint::codec {

/// The number x with odd * x == 1 modulo 2^64, by Newton's iteration: an odd number is its own
/// inverse modulo 8, and each round doubles the number of right low bits.
constexpr std::uint64_t inverse_of_odd(std::uint64_t odd) {
  std::uint64_t inverse = odd;
  for (int right_bits = 3; right_bits < 64; right_bits *= 2) inverse *= 2 - odd * inverse;
  return inverse;
}

}  // namespace tagmint::codec
