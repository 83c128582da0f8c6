#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// What the codes of one level of a family say about it.
struct TAGMINT_API LevelStats {
  std::size_t codes = 0;
  /// Smallest distance between two of these tags, or of one and its own turns.
  int min_hamming = 0;
  /// How many of these tags pass the family's complexity rule.
  std::size_t passing = 0;
  friend bool operator==(const LevelStats&, const LevelStats&) = default;
};

/// What the codes of a family say about it, whatever the family declares.
struct TAGMINT_API FamilyStats {
  /// Of a listed family, distance_histogram[d] = number of pairs of different tags whose smallest
  /// distance over the rotations is d; bits + 1 entries. Empty for a generated one.
  std::vector<std::uint64_t> distance_histogram;
  /// Of a generated family, word_distances[d] = number of words of the code at distance d from one
  /// of them, each turn of a tag being a word, on average over the words (where the code has one
  /// coset, each word sees the same); bits + 1 entries. Empty for a listed one.
  std::vector<double> word_distances;
  /// self_histogram[d] = number of tags whose self_distance() is d; bits + 1 entries.
  std::vector<std::uint64_t> self_histogram;
  /// One for each of the family's levels.
  std::vector<LevelStats> levels;
  /// Smallest distance between two tags (or a tag and its own turns): the family's true distance.
  int min_hamming = 0;
  /// false_accept_rate[r] = share of all words that lie within r bits of some turn of some tag, an
  /// upper bound counted as 4 * codes * sum_{i<=r} C(bits, i) / 2^bits and exact while r <=
  /// (min_hamming - 1) / 2; bits/2 + 1 entries, at most 1.
  std::vector<double> false_accept_rate;
};

/// Share of all words of `bits` bits that lie within `errors` bits of some turn of one of `codes`
/// tags: 4 * codes * sum_{i<=errors} C(bits, i) / 2^bits, at most 1. How likely a reading with so
/// many errors is an accident.
///   errors   0 to bits
///   cost     O(errors)
TAGMINT_API double false_accept_rate(std::size_t codes, int bits, int errors);

/// Cost, shared by `threads` threads (0 = all cores): O(codes^2) word comparisons for a listed
/// family; some 0.1 us a tag for a generated one.
TAGMINT_API FamilyStats family_stats(const Family& family, int threads = 0);

}  // namespace tagmint::codec
