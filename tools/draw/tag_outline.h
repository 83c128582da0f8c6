#pragma once

#include <vector>

#include "tagmint/codec/layout.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::draw {

/// A closed line along cell edges; its points are grid corners (0..width in x and y) where it
/// turns.
using Outline = std::vector<codec::CellPosition>;

/// The boundaries of all black areas of a tag, in grid coordinates. Filled as one path, with either
/// fill rule, they give the black cells as whole areas: no edge runs between two black cells, so no
/// renderer can leave a seam there. Outer boundaries run clockwise as seen (y down), holes the
/// other way; areas that meet at a corner only are apart.
///   cost     O(width^2)
std::vector<Outline> black_outlines(const codec::TagCells& cells);

/// The same for the cells that inverted printing leaves free: black ones and holes in the tag.
std::vector<Outline> unprinted_outlines(const codec::TagCells& cells);

/// The boundaries of the holes in a tag: Cell::None cells that the tag's own cells enclose. Nothing
/// may be painted there, not even white. Cells outside a round tag are no holes.
std::vector<Outline> hole_outlines(const codec::TagCells& cells);

}  // namespace tagmint::draw
