#include "draw/draw_tag.h"

namespace tagmint::draw {

namespace {

template <typename Corner>
void add_outline(Path& path, Corner begin, Corner end) {
  for (Corner corner = begin; corner != end; ++corner) {
    if (corner == begin) {
      path.move_to(corner->x, corner->y);
    } else {
      path.line_to(corner->x, corner->y);
    }
  }
  path.close();
}

}  // namespace

Path path_of(const std::vector<Outline>& outlines) {
  Path path;
  for (const Outline& outline : outlines) add_outline(path, outline.begin(), outline.end());
  return path;
}

Path reversed_path_of(const std::vector<Outline>& outlines) {
  Path path;
  for (const Outline& outline : outlines) add_outline(path, outline.rbegin(), outline.rend());
  return path;
}

Placement grid_placement(const Box& outer, int width_cells) {
  return {outer.x_mm, outer.y_mm, outer.width_mm / width_cells};
}

void draw_tag(Canvas& canvas, const codec::TagCells& cells, const Box& outer) {
  canvas.fill(path_of(black_outlines(cells)), grid_placement(outer, cells.width()),
              {.gray = 0.0, .role = Role::Tag});
}

void draw_inverted_tag(Canvas& canvas, const codec::Layout& layout, const codec::TagCells& cells,
                       const Box& outer, double quiet_mm, bool round) {
  const Placement place = grid_placement(outer, cells.width());
  const double quiet = quiet_mm / place.unit_mm;  // in cells, as the whole path is
  const double side = cells.width();
  Path path;
  if (round) {
    path.add_circle(side / 2, side / 2, radius_cells(layout) + quiet);
  } else {
    path.add_rectangle(-quiet, -quiet, side + 2 * quiet, side + 2 * quiet);
  }
  path.append(reversed_path_of(unprinted_outlines(cells)));
  canvas.fill(path, place, {.gray = 0.0, .role = Role::Tag});
}

}  // namespace tagmint::draw
