#include "board/board.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tagmint::board {
namespace {

constexpr int kWidestBorder = 4;

/// Sine and cosine of an angle; exact for quarter turns.
detect::Point direction(double turn_deg) {
  const double quarters = turn_deg / 90.0;
  if (quarters == std::floor(quarters)) {
    constexpr detect::Point kQuarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return kQuarters[static_cast<int>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0))];
  }
  const double angle = turn_deg * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

BoardTag make_tag(const codec::SharedFamily& family, codec::TagId id, double edge_mm,
                  detect::Point centre_mm, double turn_deg) {
  return {family, family->layout(), id, edge_mm, centre_mm, turn_deg, std::nullopt};
}

detect::Point on_board(const BoardTag& tag, detect::Point on_tag_mm) {
  const detect::Point right = direction(tag.turn_deg);
  const detect::Point down = {-right.y, right.x};
  return tag.centre_mm + on_tag_mm.x * right + on_tag_mm.y * down;
}

detect::Corners square_around(const BoardTag& tag, double side_mm) {
  detect::Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = on_board(tag, side_mm / 2 * detect::kTagCorners[i]);
  }
  return corners;
}

detect::Corners border_corners(const BoardTag& tag) { return square_around(tag, tag.edge_mm); }

double outer_mm(const BoardTag& tag) { return draw::outer_of_edge(tag.layout, tag.edge_mm); }

codec::TagCells cells_of(const BoardTag& tag) {
  return codec::tag_cells(tag.layout, tag.family->codeword(tag.id));
}

bool has_wide_border(const BoardTag& tag) {
  return tag.layout.width() != tag.family->layout().width();
}

bool is_black_on_white(const codec::Layout& layout) {
  return !layout.reversed_border() && layout.border_offset() == 1 && draw::quiet_cells(layout) == 0;
}

codec::Layout with_border(const codec::Layout& layout, int border_cells) {
  if (!is_black_on_white(layout)) {
    throw std::invalid_argument("only a black border on white can be made wider");
  }
  if (border_cells < 1 || border_cells > kWidestBorder) {
    throw std::invalid_argument(fmt::format("a border of {} cells cannot be; it is 1 to {} cells",
                                            border_cells, kWidestBorder));
  }
  const int added = border_cells - 1;
  const int width = layout.width() + 2 * added;
  std::string rows;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      const int ring = std::min({x, y, width - 1 - x, width - 1 - y});
      const codec::Cell cell = ring == 0       ? codec::Cell::White
                               : ring <= added ? codec::Cell::Black
                                               : layout.cell(x - added, y - added);
      rows += static_cast<char>(cell);
    }
  }
  return codec::Layout(rows);
}

}  // namespace tagmint::board
