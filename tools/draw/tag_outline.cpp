#include "draw/tag_outline.h"

#include <array>
#include <cstddef>

namespace tagmint::draw {
namespace {

using codec::Cell;
using codec::CellPosition;
using codec::TagCells;

/// A grid of cells that belong to an area or not; outside the grid nothing does.
class Area {
 public:
  explicit Area(int width) : width_(width), inside_(static_cast<std::size_t>(width) * width) {}

  int width() const { return width_; }
  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < width_ && inside_[index(x, y)] != 0;
  }
  void set(int x, int y, bool inside) { inside_[index(x, y)] = inside ? 1 : 0; }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  int width_;
  std::vector<char> inside_;
};

// Directions of a step along the grid, clockwise as seen: right, down, left, up.
constexpr std::array<CellPosition, 4> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
// From a grid corner, the cell on the right and on the left hand of a step in each direction.
constexpr std::array<CellPosition, 4> kRightCell = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
constexpr std::array<CellPosition, 4> kLeftCell = {{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};

/// Whether the boundary has an edge from corner (x, y) in `direction`: the area on its right hand.
bool is_edge(const Area& area, int x, int y, int direction) {
  const CellPosition right = kRightCell[direction];
  const CellPosition left = kLeftCell[direction];
  return area.at(x + right.x, y + right.y) && !area.at(x + left.x, y + left.y);
}

std::vector<Outline> trace(const Area& area) {
  const int corners = area.width() + 1;
  std::vector<std::array<bool, 4>> used(static_cast<std::size_t>(corners) * corners);
  std::vector<Outline> outlines;
  for (int y = 0; y < corners; ++y) {
    for (int x = 0; x < corners; ++x) {
      // Every boundary has steps to the right; the first one in reading order begins a straight
      // run, so every outline starts where it turns.
      constexpr int kRight = 0;
      if (!is_edge(area, x, y, kRight) || used[static_cast<std::size_t>(y) * corners + x][kRight]) {
        continue;
      }
      Outline outline;
      CellPosition at{x, y};
      int direction = kRight;
      int came_from = -1;
      while (!used[static_cast<std::size_t>(at.y) * corners + at.x][direction]) {
        used[static_cast<std::size_t>(at.y) * corners + at.x][direction] = true;
        if (direction != came_from) outline.push_back(at);
        at = {at.x + kStep[direction].x, at.y + kStep[direction].y};
        came_from = direction;
        // Turn right first, so that the line stays with its own cell where two areas touch.
        for (const int turn : {1, 0, 3}) {
          const int next = (came_from + turn) % 4;
          if (is_edge(area, at.x, at.y, next)) {
            direction = next;
            break;
          }
        }
      }
      outlines.push_back(std::move(outline));
    }
  }
  return outlines;
}

/// Absent cells that the tag's own cells enclose.
Area holes_of(const TagCells& cells) {
  const int width = cells.width();
  Area holes(width);
  std::vector<CellPosition> outside;  // absent cells reached from the tag's rim, to be followed
  const auto leave = [&](int x, int y) {
    if (!holes.at(x, y)) return;
    holes.set(x, y, false);
    outside.push_back({x, y});
  };
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) holes.set(x, y, cells.at(x, y) == Cell::None);
  }
  for (int i = 0; i < width; ++i) {
    leave(i, 0);
    leave(i, width - 1);
    leave(0, i);
    leave(width - 1, i);
  }
  while (!outside.empty()) {
    const CellPosition cell = outside.back();
    outside.pop_back();
    for (const CellPosition step : kStep) leave(cell.x + step.x, cell.y + step.y);
  }
  return holes;
}

}  // namespace

std::vector<Outline> black_outlines(const TagCells& cells) {
  Area black(cells.width());
  for (int y = 0; y < cells.width(); ++y) {
    for (int x = 0; x < cells.width(); ++x) black.set(x, y, cells.at(x, y) == Cell::Black);
  }
  return trace(black);
}

std::vector<Outline> unprinted_outlines(const TagCells& cells) {
  Area unprinted = holes_of(cells);
  for (int y = 0; y < cells.width(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (cells.at(x, y) == Cell::Black) unprinted.set(x, y, true);
    }
  }
  return trace(unprinted);
}

std::vector<Outline> hole_outlines(const TagCells& cells) { return trace(holes_of(cells)); }

}  // namespace tagmint::draw
