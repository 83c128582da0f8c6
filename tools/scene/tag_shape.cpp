#include "scene/tag_shape.h"

#include <algorithm>

#include "tagmint/codec/tag_cells.h"

namespace tagmint::scene {
namespace {

using codec::Cell;
using codec::TagCells;
using detect::Point;

/// The tag's cells with `margin` more on each side; Cell::None outside the tag.
class PaddedCells {
 public:
  PaddedCells(TagCells cells, int margin) : cells_(std::move(cells)), margin_(margin) {}

  int width() const { return cells_.width() + 2 * margin_; }
  Cell at(int x, int y) const {
    x -= margin_;
    y -= margin_;
    const bool inside = x >= 0 && y >= 0 && x < cells_.width() && y < cells_.width();
    return inside ? cells_.at(x, y) : Cell::None;
  }
  /// Whether a cell of the tag is at most the margin away, in rows and in columns.
  bool on_paper(int x, int y) const {
    for (int dy = -margin_; dy <= margin_; ++dy) {
      for (int dx = -margin_; dx <= margin_; ++dx) {
        if (at(x + dx, y + dy) != Cell::None) return true;
      }
    }
    return false;
  }

 private:
  TagCells cells_;
  int margin_;
};

/// The cells for which `wanted(x, y)`, as one rectangle for each run in a row. The grid's middle is
/// (0, 0), `half_border` cells are the unit.
template <typename Wanted>
std::vector<Rectangle> runs(int width, double half_border, Wanted wanted) {
  std::vector<Rectangle> rectangles;
  const auto plane = [&](int cell) { return (cell - width / 2.0) / half_border; };
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!wanted(x, y)) continue;
      const int first = x;
      while (x < width && wanted(x, y)) ++x;
      const double left = plane(first);
      const double right = plane(x);
      const double top = plane(y);
      const double bottom = plane(y + 1);
      rectangles.push_back({{left, top}, {right, top}, {right, bottom}, {left, bottom}});
    }
  }
  return rectangles;
}

}  // namespace

TagShape tag_shape(const codec::Layout& layout, codec::Codeword codeword, int quiet_zone_cells) {
  const PaddedCells cells(tag_cells(layout, codeword), quiet_zone_cells);
  const int width = cells.width();
  const double half_border = layout.width_at_border() / 2.0;
  const auto tag = [&](int x, int y) { return cells.at(x, y) != Cell::None; };
  const auto paper = [&](int x, int y) { return cells.on_paper(x, y); };
  const auto black = [&](int x, int y) { return cells.at(x, y) == Cell::Black; };
  return {runs(width, half_border, paper), runs(width, half_border, tag),
          runs(width, half_border, black)};
}

}  // namespace tagmint::scene
