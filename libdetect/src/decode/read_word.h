#pragma once

#include <optional>
#include <span>
#include <vector>

#include "decode/cell_grid.h"
#include "tagmint/codec/codeword.h"
#include "tagmint/codec/layout.h"

namespace tagmint::detect {

/// Which tag the cells are taken for the picture of.
struct Print {
  bool inverted = false;  ///< black where the tag is white
  bool mirrored = false;  ///< left is right
};

/// How white the cells of a quad are on a scale on which black is -1 and white is 1; by the cells
/// of the upright quad, row-major.
struct Whiteness {
  std::vector<float> value;
  std::vector<std::uint8_t> known;  ///< cells in the image that the layout prints
  std::vector<float> gray_levels;   ///< of one unit, at each cell
};

/// Cells against the planes of the rings: the threshold is half-way between black and white. False
/// when a data cell is outside the image.
bool whiteness_by_planes(const CellGrid& grid, const codec::Layout& layout, Whiteness& cells);

/// The same against one threshold for the whole tag, the geometric mean of dark and bright ring
/// cells: light in a shadow is a share of the light outside, and white there may be darker than
/// half-way. False also where nothing is dark enough for that.
///   sorted   scratch
bool whiteness_in_shadow(const CellGrid& grid, const codec::Layout& layout,
                         std::vector<double>& sorted, Whiteness& cells);

/// A word and how clearly it was read.
struct Reading {
  codec::Codeword word = 0;
  double decision_margin = 0;  ///< gray levels
};

/// The word on the cells: positive is white.
///   sharpening   weight of the difference to the four neighbours that is added against blur
Reading read_word(const codec::Layout& layout, const Whiteness& cells, double sharpening,
                  const Print& print);

/// The cell of the quad in which a cell of the tag is seen.
inline int seen_at(const codec::Layout& layout, codec::CellPosition p, const Print& print) {
  return p.y * layout.width() + (print.mirrored ? layout.width() - 1 - p.x : p.x);
}

}  // namespace tagmint::detect
