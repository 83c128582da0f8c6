#pragma once

#include <cstddef>
#include <cstdint>

namespace tagmint::detect {

/// Rows of black, its own included, that a start needs below it. Less lets through what noise and
/// texture make; the smallest tags that can be read are higher in any direction.
inline constexpr int kStartDepth = 5;

/// Words of the largest vector of bits: rows are read and written up to the next multiple.
inline constexpr int kBitVectorWords = 8;

/// Rows of bits in memory: word w of row y is first[y * stride + w].
struct BitBlock {
  const std::uint64_t* first = nullptr;
  std::ptrdiff_t stride = 0;
};

/// Finds runs of black on which a shape may begin: no pixel of the run has black right above it,
/// and from some pixel of it a path of black leads down over kStartDepth rows, in steps to one of
/// the three pixels below or along the row. 64 columns at a time are judged alone: a part of a run
/// that a word's edge cuts off counts as a run, and what the neighbouring word holds is taken for
/// black. So every true start is among those found, together with some near the edges of words that
/// are none.
///   black    row -1 and the kStartDepth - 1 rows after the last are read
///   rows     of them, from black.first on
///   words    in each row; whole vectors of up to kBitVectorWords are read
///   starts   gets one bit for each start, its last pixel within the word; whole vectors are
///   written starts_stride   words from one row of starts to the next cost     about 60 operations
///   on bits for each vector of a row, less where nothing is black
void find_starts(BitBlock black, int rows, int words, std::uint64_t* starts,
                 std::ptrdiff_t starts_stride);

namespace scalar {

/// The same, a word at a time.
void find_starts(BitBlock black, int rows, int words, std::uint64_t* starts,
                 std::ptrdiff_t starts_stride);

}  // namespace scalar

}  // namespace tagmint::detect
