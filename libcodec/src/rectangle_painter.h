#pragma once

#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// Counts the rectangles of the complexity rule `rectangles` (count_rectangles() in complexity.h).
/// The map from grid cells to bits is made once; count() may run in many threads at once.
class RectanglePainter {
 public:
  explicit RectanglePainter(const Layout& layout);

  /// Rectangles that the greedy painter needs for `word`, but at most `stop_at`: it stops painting
  /// there.
  ///   cost   O(rectangles * side^4 / 4) additions
  int count(Codeword word, int stop_at) const;

 private:
  int side_ = 0;                // of the square around the data cells
  std::vector<int> bit_shift_;  // row-major, side_ * side_; kNoBit where a cell carries no data
};

}  // namespace tagmint::codec
