#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "false_accepts/measured_codes.h"

namespace tagmint::bench {

/// How many of `words` random words a code accepted, by corrected bits.
struct WordCounts {
  std::uint64_t words = 0;
  std::vector<std::uint64_t> accepted;  ///< accepted[r] with at most r errors
};

/// Decodes random words of the code's width: words `0 .. words - 1` of the sequence that the seed
/// names, whatever the number of threads (0 = all cores).
WordCounts decode_random_words(const codec::Decoder& decoder, std::uint64_t words,
                               std::uint64_t seed, int threads);

/// Random words at up to two errors, and fewer of them at the safe radius; a line for each radius
/// 0, 1, 2 and the safe one.
struct RandomWordsPlan {
  std::uint64_t words_at_two = 0;
  std::uint64_t words_at_safe = 0;
  std::uint64_t seed = 1;
  int threads = 0;
};
Table random_words_table(std::span<const MeasuredCode> codes, const RandomWordsPlan& plan);

}  // namespace tagmint::bench
