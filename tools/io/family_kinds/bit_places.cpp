#include "io/family_kinds/bit_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tagmint::io {
namespace {

using codec::Cell;
using codec::CellPosition;
using codec::Layout;

constexpr int kMostWidth = 64;  // of a Layout

/// A square of cells that is being filled.
class Grid {
 public:
  explicit Grid(int width)
      : width_(width), cells_(static_cast<std::size_t>(width) * width, char(Cell::None)) {}

  char& at(int x, int y) { return cells_[static_cast<std::size_t>(y) * width_ + x]; }
  const std::string& cells() const { return cells_; }

  bool ring_is_empty(int ring) const {
    bool empty = true;
    for_ring(ring, [&](std::size_t place) { empty = empty && cells_[place] == char(Cell::None); });
    return empty;
  }
  void fill_ring(int ring, Cell colour) {
    for_ring(ring, [&](std::size_t place) { cells_[place] = char(colour); });
  }

 private:
  /// Calls visit with the place of each cell that is `ring` cells from the outer edge.
  template <typename Visit>
  void for_ring(int ring, Visit visit) const {
    for (int y = ring; y < width_ - ring; ++y) {
      const bool whole_row = y == ring || y == width_ - 1 - ring;
      for (int x = ring; x < width_ - ring;
           x += whole_row ? 1 : std::max(1, width_ - 1 - 2 * ring)) {
        visit(static_cast<std::size_t>(y) * width_ + x);
      }
    }
  }

  int width_;
  std::string cells_;
};

int offset_of(const BitPlaces& places) {
  const int around = places.total_width - places.width_at_border;
  if (places.total_width > kMostWidth || places.width_at_border < 1 || around < 2 ||
      around % 2 != 0) {
    throw std::invalid_argument(
        fmt::format("a border square {} cells wide in a tag {} cells wide cannot be",
                    places.width_at_border, places.total_width));
  }
  return around / 2;
}

}  // namespace

Layout layout_of_places(const BitPlaces& places) {
  const int offset = offset_of(places);
  const int width = places.total_width;
  Grid grid(width);
  for (const CellPosition place : places.cells) {
    const CellPosition cell{place.x + offset, place.y + offset};
    if (cell.x < 0 || cell.y < 0 || cell.x >= width || cell.y >= width) {
      throw std::invalid_argument(
          fmt::format("the bit at ({}, {}) lies outside of the tag", place.x, place.y));
    }
    if (grid.at(cell.x, cell.y) == char(Cell::Data)) {
      throw std::invalid_argument(fmt::format("two bits at ({}, {})", place.x, place.y));
    }
    grid.at(cell.x, cell.y) = char(Cell::Data);
  }
  const Cell outside = places.reversed_border ? Cell::Black : Cell::White;
  const Cell inside = places.reversed_border ? Cell::White : Cell::Black;
  for (const int ring : {offset - 1, offset}) {
    if (!grid.ring_is_empty(ring)) {
      throw std::invalid_argument("a bit lies in the border of the tag");
    }
  }
  grid.fill_ring(offset - 1, outside);
  for (int ring = offset; 2 * ring < width && grid.ring_is_empty(ring); ++ring) {
    grid.fill_ring(ring, inside);
  }
  return Layout(grid.cells());
}

std::vector<int> order_of_places(const BitPlaces& places, const Layout& layout) {
  const int offset = offset_of(places);
  const int bits = static_cast<int>(places.cells.size());
  if (layout.width() != places.total_width || layout.bits() != bits ||
      layout.border_offset() != offset || layout.reversed_border() != places.reversed_border) {
    throw std::invalid_argument(fmt::format(
        "the file has {} bits in a tag {} cells wide with a border square of {}, the layout {}, {} "
        "and {}, or the colours of the border differ",
        bits, places.total_width, places.width_at_border, layout.bits(), layout.width(),
        layout.width_at_border()));
  }
  std::vector<int> order;
  for (const CellPosition cell : layout.data_cells()) {
    const auto place = std::find(places.cells.begin(), places.cells.end(),
                                 CellPosition{cell.x - offset, cell.y - offset});
    if (place == places.cells.end()) {
      throw std::invalid_argument(
          fmt::format("no bit lies at the data cell ({}, {})", cell.x - offset, cell.y - offset));
    }
    order.push_back(bits - 1 - static_cast<int>(place - places.cells.begin()));
  }
  return order;
}

codec::Codeword in_order(codec::Codeword listed, const std::vector<int>& order) {
  codec::Codeword word = 0;
  for (const int bit : order) word = word << 1 | (listed >> bit & 1);
  return word;
}

}  // namespace tagmint::io
