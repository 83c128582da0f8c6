#pragma once

#include <vector>

#include "draw/canvas.h"
#include "draw/sheet_plan.h"
#include "draw/tag_outline.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::draw {

/// Outlines in grid coordinates of a tag as a path whose unit is the cell.
Path path_of(const std::vector<Outline>& outlines);

/// The same with each outline the other way round: a path of holes.
Path reversed_path_of(const std::vector<Outline>& outlines);

/// Where that path of a tag `width_cells` wide stands, to fill the square `outer`.
Placement grid_placement(const Box& outer, int width_cells);

/// Fills the black cells of a tag as one path, pure black, so that no renderer can leave a seam
/// between cells. White cells are the paper; where the layout has no cell, nothing is drawn.
///   outer   the whole tag, a square
void draw_tag(Canvas& canvas, const codec::TagCells& cells, const Box& outer);

/// Fills, the other way about, what is white of a tag and its quiet zone, and leaves free its black
/// cells and holes: for white toner or engraving on dark material.
///   quiet_mm   width of the quiet zone around the tag
///   round      the quiet zone ends with a circle around the tag's cells, not with a square
void draw_inverted_tag(Canvas& canvas, const codec::Layout& layout, const codec::TagCells& cells,
                       const Box& outer, double quiet_mm, bool round);

}  // namespace tagmint::draw
