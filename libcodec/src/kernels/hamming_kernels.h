#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "four_turns.h"
#include "tagmint/codec/codeword.h"

/// Comparisons of one probe with many codewords, the inner loops of family statistics and searches.
/// Each comes twice: a scalar reference, and a version written once with Highway and chosen at run
/// time for the machine's best instructions. Both give the same answers.
namespace tagmint::codec {

/// Number of pairs (or words) at each Hamming distance 0..64.
using DistanceHistogram = std::array<std::uint64_t, kMaxBits + 1>;

/// Index of the first of `words` within `radius` bits of `probe`; words.size() when there is none.
///   cost   O(index), some ten words a nanosecond with AVX-512
std::size_t first_within(std::span<const Codeword> words, Codeword probe, int radius);

/// Index of the first of `words` within `radius` bits of any of the four probes; words.size() when
/// there is none.
std::size_t first_within(std::span<const Codeword> words, const FourTurns& probes, int radius);

/// Adds to `histogram`, for each of `words`, its distance to `probe`.
void add_distances(std::span<const Codeword> words, Codeword probe, DistanceHistogram& histogram);

/// Adds to `histogram`, for each of `words`, the smallest of its distances to the four probes.
void add_distances(std::span<const Codeword> words, const FourTurns& probes,
                   DistanceHistogram& histogram);

namespace scalar {
std::size_t first_within(std::span<const Codeword> words, Codeword probe, int radius);
std::size_t first_within(std::span<const Codeword> words, const FourTurns& probes, int radius);
void add_distances(std::span<const Codeword> words, Codeword probe, DistanceHistogram& histogram);
void add_distances(std::span<const Codeword> words, const FourTurns& probes,
                   DistanceHistogram& histogram);
}  // namespace scalar

}  // namespace tagmint::codec
