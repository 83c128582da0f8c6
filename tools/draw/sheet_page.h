#pragma once

#include <cairo.h>

#include <cstddef>

#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"

namespace tagmint::draw {

/// Draws a page of a plan. The context's unit is the millimetre.
void draw_page(cairo_t* context, const SheetPlan& plan, std::size_t page, const SheetDecor& decor);

/// Paints the paper of a page white, for files that are shown on other grounds: all of it but the
/// holes in tags, where the layout has no cell.
void draw_paper(cairo_t* context, const SheetPlan& plan, std::size_t page);

}  // namespace tagmint::draw
