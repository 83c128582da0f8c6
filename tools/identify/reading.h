#pragma once

#include <vector>

#include "identify/cell_grid.h"
#include "tagmint/codec/codeword.h"
#include "tagmint/codec/layout.h"

namespace tagmint::identify {

/// How much of what surrounds the data cells is in the picture.
enum class BorderPart {
  Whole,  ///< all cells of the tag
  Cut,    ///< cells outside the border square are missing; the ring inside it is there
  None,   ///< the border itself is missing: not much more than the data cells is there
};

/// The word that the data cells of a grid show.
struct Reading {
  codec::Codeword word = 0;
  bool inverted = false;  ///< black and white are exchanged
  BorderPart border = BorderPart::Whole;
  /// All data cells but one in twenty are nearer to black or white than to the middle between them,
  /// as in print; what texture makes of cells is not.
  bool clear = false;
};

/// Reads a grid as a tag of `layout`, whose frame is that of the grid. Where the border is there,
/// the rings on both sides of the border square give black and white, as planes over the tag, and
/// must be even; where the outer one is missing, the cells fall into two gray levels, the inner
/// ring into one of them. Where both are missing, either colour may be black: two readings,
/// if they are clear.
///   returns   nothing where a data cell is missing, there is no contrast, the gray levels of cells
///             of one colour scatter too much, or too many of the fixed cells have the wrong colour
std::vector<Reading> read_tag(const CellGrid& grid, const codec::Layout& layout);

}  // namespace tagmint::identify
