#include "draw/draw_tag.h"

namespace tagmint::draw {

Path path_of(const std::vector<Outline>& outlines) {
  Path path;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      if (i == 0) {
        path.move_to(outline[i].x, outline[i].y);
      } else {
        path.line_to(outline[i].x, outline[i].y);
      }
    }
    path.close();
  }
  return path;
}

Placement grid_placement(const Box& outer, int width_cells) {
  return {outer.x_mm, outer.y_mm, outer.width_mm / width_cells};
}

void draw_tag(Canvas& canvas, const codec::TagCells& cells, const Box& outer) {
  canvas.fill(path_of(black_outlines(cells)), grid_placement(outer, cells.width()),
              {.gray = 0.0, .role = Role::Tag});
}

}  // namespace tagmint::draw
