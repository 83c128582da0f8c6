#pragma once

#include <cstdint>
#include <span>
#include <string>
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

struct RandomWordsPlan {
  std::uint64_t words_at_two = 0;   ///< decoded with up to two errors
  std::uint64_t words_at_safe = 0;  ///< decoded with up to the safe radius, where that is larger
  std::uint64_t seed = 1;
  int threads = 0;
};

/// What a code accepted of the plan's words.
struct RandomWords {
  WordCounts at_two;
  WordCounts at_safe;  ///< no words where the safe radius is at most 2
};
std::vector<RandomWords> count_random_words(std::span<const MeasuredCode> codes,
                                            const RandomWordsPlan& plan);

/// A line a code: words accepted with up to 0, 1, 2 and safe_errors errors, and in brackets what
/// the formula expects.
Table random_words_table(std::span<const RandomWords> counts, std::span<const MeasuredCode> codes);

/// A line for each code and number of corrected bits, with the 95 % interval of the rate.
Table random_words_by_errors(std::span<const RandomWords> counts,
                             std::span<const MeasuredCode> codes);

/// How many of those intervals hold the formula's rate; 95 % of them should.
std::string agreement(std::span<const RandomWords> counts, std::span<const MeasuredCode> codes);

}  // namespace tagmint::bench
