#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "search/rotation/turn_code.h"

/// Plain ways to look at and to make small closed codes.
namespace tagmint::test {

/// All sums of `words`; of independent ones, each once.
inline std::vector<codec::Codeword> sums_of(std::span<const codec::Codeword> words) {
  std::vector<codec::Codeword> sums = {0};
  for (const codec::Codeword word : words) {
    const std::size_t half = sums.size();
    for (std::size_t i = 0; i < half; ++i) sums.push_back(sums[i] ^ word);
  }
  return sums;
}

inline std::vector<codec::Codeword> words_of(const codec::TurnCode& code) {
  return sums_of(code.rows());
}

/// The closed code that `words` and their turns span.
inline codec::TurnCode code_of(int bits, std::span<const codec::Codeword> words) {
  codec::TurnCode code(bits);
  code.adjoin(words);
  return code;
}
inline codec::TurnCode code_of(int bits, std::initializer_list<codec::Codeword> words) {
  return code_of(bits, std::span(words.begin(), words.size()));
}

inline bool is_closed(const codec::TurnCode& code) {
  return std::all_of(code.rows().begin(), code.rows().end(), [&](codec::Codeword word) {
    return code.contains(codec::rotate_quarter(word, code.bits()));
  });
}

inline bool contains(const codec::TurnCode& outer, const codec::TurnCode& inner) {
  return std::all_of(inner.rows().begin(), inner.rows().end(),
                     [&](codec::Codeword word) { return outer.contains(word); });
}

/// Whether each prefix of the basis spans a closed code.
inline bool prefixes_are_closed(const codec::TurnCode& code) {
  for (int dimension = 0; dimension <= code.dimension(); ++dimension) {
    const codec::TurnCode prefix = code.prefix(dimension);
    if (prefix.dimension() != dimension || !is_closed(prefix)) return false;
  }
  return true;
}

/// Whether the basis of `code` begins with that of `floor`.
inline bool begins_with(const codec::TurnCode& code, const codec::TurnCode& floor) {
  return floor.dimension() <= code.dimension() &&
         std::equal(floor.basis().begin(), floor.basis().end(), code.basis().begin());
}

/// The least weight of a word but 0, word by word; kMaxBits + 1 where there is none.
inline int plain_least_weight(std::span<const codec::Codeword> basis) {
  int least = codec::kMaxBits + 1;
  codec::Codeword word = 0;
  for (std::uint64_t step = 1; step < std::uint64_t{1} << basis.size(); ++step) {
    word ^= basis[static_cast<std::size_t>(std::countr_zero(step))];
    least = std::min(least, std::popcount(word));
  }
  return least;
}

/// Whether all words but 0 have at least that weight, and `divisor` divides all weights.
inline bool has_weights(const codec::TurnCode& code, int at_least, int divisor) {
  const std::vector<codec::Codeword> words = words_of(code);
  return std::all_of(words.begin(), words.end(), [&](codec::Codeword word) {
    return word == 0 || (std::popcount(word) >= at_least && std::popcount(word) % divisor == 0);
  });
}

/// The least of the four turns of a word.
inline codec::Codeword least_turn(codec::Codeword word, int bits) {
  codec::Codeword least = word;
  for (int turn = 1; turn < 4; ++turn) least = std::min(least, codec::rotate(word, bits, turn));
  return least;
}

/// Whether tags are so far apart in all turns, and each from its own turns.
inline bool are_apart(std::span<const codec::Codeword> tags, int bits, int distance) {
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (codec::self_distance(tags[i], bits) < distance) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (codec::rotation_distance(tags[i], tags[j], bits) < distance) return false;
    }
  }
  return true;
}

/// A random closed code, grown one dimension at a time.
inline codec::TurnCode random_code(int bits, int dimension, codec::RandomChoice& random) {
  codec::TurnCode code(bits);
  while (code.dimension() < dimension) {
    const std::vector<codec::Codeword> ways = codec::one_step_extensions(code, nullptr);
    codec::Codeword sum = 0;
    while (sum == 0) {
      for (const codec::Codeword way : ways) sum ^= random.below(2) == 1 ? way : 0;
    }
    code.extend(sum);
  }
  return code;
}

}  // namespace tagmint::test
