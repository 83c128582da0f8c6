#pragma once

#include <cstddef>
#include <cstdint>

namespace tagmint::codec {

/// How a WalkSieve splits its work. Any plan finds the same words.
struct SievePlan {
  /// Low bits that the words of a group agree in; where the others do not fit into 32 bits there
  /// are no groups but the coarse ones.
  int fine_bits = 0;
  /// A group is compared with the codes whose fine bits differ in at most so many.
  int fine_weight = 0;
  /// Lowest bits that the words of a coarse group agree in, <= fine_bits.
  int coarse_bits = 0;
  /// A coarse group is compared with codes whose coarse bits differ in at most so many before it is
  /// compared with all.
  int coarse_weight = 0;
};

/// The plan that a model of the work finds cheapest.
SievePlan plan_sieve(int bits, int min_hamming, std::size_t turns, std::uint64_t stretch);

}  // namespace tagmint::codec
