#pragma once

#include <vector>

#include "draw/canvas.h"
#include "draw/sheet_plan.h"
#include "draw/tag_outline.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::draw {

/// Outlines in grid coordinates of a tag as a path whose unit is the cell.
Path path_of(const std::vector<Outline>& outlines);

/// Where that path of a tag `width_cells` wide stands, to fill the square `outer`.
Placement grid_placement(const Box& outer, int width_cells);

/// Fills the black cells of a tag as one path, pure black, so that no renderer can leave a seam
/// between cells. White cells are the paper; where the layout has no cell, nothing is drawn.
///   outer   the whole tag, a square
void draw_tag(Canvas& canvas, const codec::TagCells& cells, const Box& outer);

}  // namespace tagmint::draw
