#include "draw/draw_tag.h"

namespace tagmint::draw {

void add_outlines(cairo_t* context, const std::vector<Outline>& outlines, int width_cells,
                  const Box& outer) {
  const auto x = [&](const codec::CellPosition& corner) {
    return outer.x_mm + outer.width_mm * corner.x / width_cells;
  };
  const auto y = [&](const codec::CellPosition& corner) {
    return outer.y_mm + outer.height_mm * corner.y / width_cells;
  };
  for (const Outline& outline : outlines) {
    cairo_new_sub_path(context);
    for (const codec::CellPosition& corner : outline) cairo_line_to(context, x(corner), y(corner));
    cairo_close_path(context);
  }
}

void draw_tag(cairo_t* context, const codec::TagCells& cells, const Box& outer) {
  cairo_set_source_rgb(context, 0, 0, 0);
  cairo_new_path(context);
  add_outlines(context, black_outlines(cells), cells.width(), outer);
  cairo_fill(context);
}

}  // namespace tagmint::draw
