#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::codec {

/// What became of a round of words.
struct Round {
  std::uint64_t judged = 0;     ///< words done; fewer than sifted only where max_codes was reached
  std::vector<Codeword> taken;  ///< new codes, in order
  std::size_t overlapping = 0;  ///< sifted in vain: too near to a code of the same round
};

/// The greedy choice itself: goes through the words of a round that are left by the sieve, in
/// order, and takes each one that is far enough from those taken before in the same round. The
/// sieve knows all codes before the round, so that the choice depends neither on the number of
/// threads that sift nor on the size of the rounds.
///   first, count   the words that were sifted
///   max_codes      stop behind the code that makes as many; >= 1
Round choose_greedily(const SiftedWords& sifted, int bits, int min_hamming, std::uint64_t first,
                      std::uint64_t count, std::size_t max_codes);

}  // namespace tagmint::codec
