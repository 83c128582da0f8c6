#include "scene/fill.h"

namespace tagmint::scene {

using detect::Point;

PixelBox cover(std::span<const Point> polygon, const Window& window, Coverage& coverage) {
  std::vector<Point> on_grid;
  on_grid.reserve(polygon.size());
  for (const Point p : polygon) on_grid.push_back(window.to_grid(p));
  const PixelBox box = box_of(on_grid, window.columns(), window.rows);
  if (box.empty()) return box;
  const Point origin{static_cast<double>(box.x0), static_cast<double>(box.y0)};
  for (Point& p : on_grid) p = p - origin;
  coverage.reset(box.width(), box.height());
  coverage.add(on_grid);
  return box;
}

void paint(std::span<const Patch> patches, const Window& window, GrayPlane& plane) {
  Coverage coverage(1, 1);
  for (const Patch& patch : patches) {
    const PixelBox box = cover(patch.polygon, window, coverage);
    for (int y = box.y0; y < box.y1; ++y) {
      Coverage::Row row = coverage.row(y - box.y0);
      float* level = plane.row(y);
      for (int x = box.x0; x < box.x1; ++x) {
        level[x] += static_cast<float>(row.next() * (patch.gray - level[x]));
      }
    }
  }
}

}  // namespace tagmint::scene
