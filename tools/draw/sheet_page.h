#pragma once

#include <cstddef>

#include "draw/canvas.h"
#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"

namespace tagmint::draw {

/// Draws what a page of a plan holds; the page was begun.
void draw_page(Canvas& canvas, const SheetPlan& plan, std::size_t page, const SheetDecor& decor);

/// The paper of a page: all of it but the holes in tags, where the layout has no cell.
Path paper_of(const SheetPlan& plan, std::size_t page);

}  // namespace tagmint::draw
