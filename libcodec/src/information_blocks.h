#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"

/// How a linear code is searched for its words near a given one [Prange1962],
/// [LeeBrickell1988]. The bits of a word are shared out among blocks. A word with few
/// errors has very few of them in some block, and with the code's words told by their bits in that
/// block, few candidates are left.
namespace tagmint::codec {

/// Some bits of a word in which the sums of a basis take every pattern.
struct InformationBlock {
  /// The bits, counted from the least significant.
  std::vector<int> positions;
  /// columns[i]: the sum that is 1 in positions[i] and 0 in the other positions.
  std::vector<Codeword> columns;
  /// Basis of the sums that are 0 in all positions: with the columns, a basis of all sums.
  std::vector<Codeword> kernel;
};

/// The block that a walk through `positions` collects: each position that is free, given those
/// before it.
///   basis   independent words
///   cost    O(positions * basis)
InformationBlock make_block(std::span<const Codeword> basis, std::span<const int> positions);

/// A block, and how many errors in it are reckoned with.
struct BlockSearch {
  InformationBlock block;
  int errors = 0;
};

/// Number of sums that differ from a given word in at most `errors` of the block's positions, the
/// candidates of one coset.
double count_candidates(const BlockSearch& search);

/// Blocks and errors such that every word with at most `radius` errors has no more than the errors
/// of a block in that block, for one of them: the sum of errors + 1 is radius + 1 or more. Of
/// several ways to share the bits out, the one with the fewest candidates; where blocks are of no
/// use, an empty block, whose candidates are all sums.
///   basis    independent words of `bits` bits
///   cosets   how many cosets are to be searched, each with the same candidates
///   cost     O(bits^2 * basis), some hundred microseconds
std::vector<BlockSearch> plan_search(std::span<const Codeword> basis, int bits, std::size_t cosets,
                                     int radius);

}  // namespace tagmint::codec
