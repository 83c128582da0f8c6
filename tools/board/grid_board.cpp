#include "board/grid_board.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "board/clearance.h"
#include "draw/units.h"

namespace tagmint::board {
namespace {

// Lengths are told rounded to a micrometre, so a told one is taken.
constexpr double kSlackMm = 1e-3;

void check(const codec::Family& family, const Grid& grid, std::span<const codec::TagId> ids) {
  if (grid.columns < 1 || grid.rows < 1) {
    throw std::invalid_argument(
        fmt::format("a grid of {} x {} cannot be; it has at least one column and one row",
                    grid.columns, grid.rows));
  }
  for (const double length : {grid.edge_mm, grid.gap_mm}) {
    if (!std::isfinite(length) || length <= 0) {
      throw std::invalid_argument(
          fmt::format("an edge or gap of {} mm cannot be; it is above 0", length));
    }
  }
  const std::size_t places = static_cast<std::size_t>(grid.columns) * grid.rows;
  if (ids.size() != places) {
    throw std::invalid_argument(
        fmt::format("a grid of {} x {} has {} places, and {} ids were given; give as many ids as "
                    "places",
                    grid.columns, grid.rows, places, ids.size()));
  }
  for (const codec::TagId id : ids) {
    if (id >= family.size()) {
      throw std::invalid_argument(fmt::format("id {} is not in {}; its ids are 0-{}", id,
                                              family.name(), family.size() - 1));
    }
  }
}

/// The layout that is printed.
codec::Layout printed_layout(const codec::Family& family, const Grid& grid) {
  const codec::Layout& layout = family.layout();
  if (!is_black_on_white(layout)) {
    if (grid.style == Style::Kalibr) {
      throw std::invalid_argument(fmt::format(
          "{} has data outside its border square, where the squares of the style kalibr "
          "would touch it; take a family of a classic layout, like tag36h11, or the "
          "style plain",
          family.name()));
    }
    if (grid.border_cells != 1) {
      throw std::invalid_argument(
          fmt::format("the border of {} has data around it and cannot be made wider; take a family "
                      "of a classic layout, like tag36h11",
                      family.name()));
    }
    return layout;
  }
  return with_border(layout, grid.border_cells);
}

void check_gap(const codec::Family& family, const codec::Layout& layout, const Grid& grid) {
  const bool alone = grid.columns == 1 && grid.rows == 1 && grid.style == Style::Plain;
  const double least = least_gap_mm(layout, grid.edge_mm);
  if (alone || grid.gap_mm >= least - kSlackMm) return;
  // Rounded up, so that the spacing that is told is one that fits.
  const double least_spacing = std::ceil(1000 * least / grid.edge_mm - 1e-9) / 1000;
  throw draw::DoesNotFit(
      fmt::format("a gap of {} between border squares is too narrow: one tag would reach into the "
                  "quiet zone of the next",
                  draw::format_mm(grid.gap_mm)),
      fmt::format("{} with edge {}", family.name(), draw::format_mm(grid.edge_mm)),
      fmt::format("give at least --spacing {} or {}", least_spacing, draw::format_mm(least, "")));
}

/// Squares at all corners of the border squares, also at those on the rim.
void add_squares(Board& board, const Grid& grid) {
  const double pitch = grid.edge_mm + grid.gap_mm;
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column) {
      board.squares.push_back({(column - grid.columns / 2.0) * pitch - grid.gap_mm / 2,
                               (row - grid.rows / 2.0) * pitch - grid.gap_mm / 2, grid.gap_mm,
                               grid.gap_mm});
    }
  }
  const double width = grid.columns * pitch + grid.gap_mm;
  const double height = grid.rows * pitch + grid.gap_mm;
  board.extent = {-width / 2, -height / 2, width, height};
}

}  // namespace

Board plan_grid(const codec::SharedFamily& family, const Grid& grid,
                std::span<const codec::TagId> ids, std::span<const draw::NestedRequest> nested) {
  check(*family, grid, ids);
  const codec::Layout layout = printed_layout(*family, grid);
  check_gap(*family, layout, grid);
  const std::vector<double> edges = draw::nested_edges(*family, grid.edge_mm, nested);
  const double pitch = grid.edge_mm + grid.gap_mm;

  Board board;
  board.grid = grid;
  for (std::size_t place = 0; place < ids.size(); ++place) {
    const int column = static_cast<int>(place) % grid.columns;
    const int row_in_order = static_cast<int>(place) / grid.columns;
    const int row = grid.style == Style::Kalibr ? grid.rows - 1 - row_in_order : row_in_order;
    const detect::Point centre = {(column - (grid.columns - 1) / 2.0) * pitch,
                                  (row - (grid.rows - 1) / 2.0) * pitch};
    std::optional<std::size_t> host;
    board.tags.push_back({family, layout, ids[place], grid.edge_mm, centre, 0.0, host});
    for (std::size_t level = 0; level < nested.size(); ++level) {
      const codec::SharedFamily& inner = nested[level].family;
      const std::size_t id = nested[level].id + place;
      if (id >= inner->size()) {
        throw std::invalid_argument(
            fmt::format("{} has no tag {} for the hole of the last tag; its ids are 0-{}",
                        inner->name(), id, inner->size() - 1));
      }
      host = board.tags.size() - 1;
      board.tags.push_back(
          {inner, inner->layout(), static_cast<codec::TagId>(id), edges[level], centre, 0.0, host});
    }
  }
  check_each_once(board.tags);
  if (grid.style == Style::Kalibr) {
    add_squares(board, grid);
  } else {
    board.extent = extent_of(board.tags);
  }
  return board;
}

}  // namespace tagmint::board
