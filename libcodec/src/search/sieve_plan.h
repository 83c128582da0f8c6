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

/// The plan that a model of the work finds cheapest: how many codes of each closeness there are and
/// how many words each excludes, were words and codes random, at costs measured with AVX-512.
///   bits, min_hamming   1..64, 1..bits
///   stretch             1..2^32 words
///   returns             fine_bits at most 24 and so few that groups have 16 words where they can
///   cost                below a millisecond
SievePlan plan_sieve(int bits, int min_hamming, std::size_t turns, std::uint64_t stretch);

}  // namespace tagmint::codec
