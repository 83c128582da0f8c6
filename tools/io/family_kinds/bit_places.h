#pragma once

#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/layout.h"

namespace tagmint::io {

/// A layout as libapriltag knows it: where each bit is, from the most significant, in cells from
/// the top left corner of the border square.
struct BitPlaces {
  std::vector<codec::CellPosition> cells;
  int width_at_border = 0;
  int total_width = 0;
  bool reversed_border = false;
};

/// The layout with these data cells and this border. What libapriltag leaves open is taken so:
/// whole rings without data next to the border square, inside of it, have the border's colour;
/// other cells are no cells (Cell::None). Throws std::invalid_argument for places that overlap, lie
/// outside of the tag or in the border, and for what is no layout.
codec::Layout layout_of_places(const BitPlaces& places);

/// For each bit of the layout's codewords, from the most significant, which bit of a listed word it
/// is, counted from the least significant. Throws std::invalid_argument unless the layout's data
/// cells are exactly these places and its border square is theirs.
std::vector<int> order_of_places(const BitPlaces& places, const codec::Layout& layout);

/// The codeword that a listed word is.
codec::Codeword in_order(codec::Codeword listed, const std::vector<int>& order);

}  // namespace tagmint::io
