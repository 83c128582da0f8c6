#pragma once

#include <cairo.h>

#include <vector>

#include "draw/sheet_plan.h"
#include "draw/tag_outline.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::draw {

/// Adds outlines in grid coordinates of a tag `width_cells` wide to the context's path, scaled to
/// fill `outer`.
void add_outlines(cairo_t* context, const std::vector<Outline>& outlines, int width_cells,
                  const Box& outer);

/// Fills the black cells of a tag as one path, pure black, so that no renderer can leave a seam
/// between cells. White cells are the paper; where the layout has no cell, nothing is drawn.
void draw_tag(cairo_t* context, const codec::TagCells& cells, const Box& outer);

}  // namespace tagmint::draw
