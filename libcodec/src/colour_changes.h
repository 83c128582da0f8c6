#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// The colour changes of a tag, one bit each. 256 places are enough: each of at most 64 data cells
/// has four neighbours.
using ChangeBits = std::array<std::uint64_t, 4>;

/// Counts the colour changes of the complexity rule `energy` (count_colour_changes() in
/// complexity.h) from masks made once. Copyable; count() may run in many threads at once.
class ColourChanges {
 public:
  explicit ColourChanges(const Layout& layout);

  /// Pairs of 4-neighbours of different colour in the tag that carries `word`.
  int count(Codeword word) const;

  /// The changes that data cells make, each at a place of its own: count() = their number +
  /// fixed_changes(). Each bit depends on one or two bits of the word by XOR, so the map from words
  /// is linear but for what the word 0 has. Cost: O(pairs).
  ChangeBits change_bits(Codeword word) const;

  /// The changes between fixed cells.
  int fixed_changes() const { return fixed_changes_; }

  /// Cells that are drawn.
  int cells() const { return cells_; }

 private:
  int cells_ = 0;
  int fixed_changes_ = 0;  // between two fixed cells
  // Bit shifts of two neighbouring data cells.
  std::vector<std::pair<int, int>> data_pairs_;
  // beside_black_[k]: the data bits with more than k black fixed neighbours; a white one of them
  // makes a change with each. beside_white_ likewise.
  std::array<Codeword, 4> beside_black_{};
  std::array<Codeword, 4> beside_white_{};
};

}  // namespace tagmint::codec
