#include "tagmint/codec/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {
namespace {

constexpr int kMaxWidth = 64;

std::vector<std::string_view> split_rows(std::string_view text) {
  std::vector<std::string_view> rows;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('/', begin), text.size());
    rows.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return rows;
}

/// Rows of equal length joined, checked to be a square of cells.
std::string join_square(std::string_view text) {
  if (text.find('/') == std::string_view::npos) {
    const auto side = static_cast<std::size_t>(std::lround(std::sqrt(double(text.size()))));
    if (side * side != text.size()) {
      throw std::invalid_argument(fmt::format(
          "layout has {} cells, which is not a square; write whole rows, with '/' between them",
          text.size()));
    }
    return std::string(text);
  }
  const std::vector<std::string_view> rows = split_rows(text);
  std::string cells;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (rows[y].size() != rows.size()) {
      throw std::invalid_argument(
          fmt::format("layout row {} has {} cells, but there are {} rows; a tag is a square", y,
                      rows[y].size(), rows.size()));
    }
    cells += rows[y];
  }
  return cells;
}

}  // namespace

Layout::Layout(std::string_view text) : cells_(join_square(text)) {
  width_ = static_cast<int>(std::lround(std::sqrt(double(cells_.size()))));
  if (width_ < 1 || width_ > kMaxWidth) {
    throw std::invalid_argument(
        fmt::format("layout is {} cells wide; 1 to {} are possible", width_, kMaxWidth));
  }
  const std::size_t odd = cells_.find_first_not_of("dbwx");
  if (odd != std::string::npos) {
    throw std::invalid_argument(
        fmt::format("layout has '{}' in row {}, column {}; cells are d (data), b (black), w "
                    "(white), x (no cell)",
                    cells_[odd], odd / width_, odd % width_));
  }
  check_symmetry();
  find_data_cells();
  find_border();
}

std::vector<std::string> Layout::rows() const {
  std::vector<std::string> rows;
  for (int y = 0; y < width_; ++y) rows.push_back(cells_.substr(std::size_t(y) * width_, width_));
  return rows;
}

void Layout::check_symmetry() const {
  for (int y = 0; y < width_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const int turned_x = width_ - 1 - y;
      const int turned_y = x;
      if (cell(x, y) != cell(turned_x, turned_y)) {
        throw std::invalid_argument(fmt::format(
            "layout changes under a quarter turn: row {}, column {} is '{}' but row {}, column {} "
            "is '{}'",
            y, x, char(cell(x, y)), turned_y, turned_x, char(cell(turned_x, turned_y))));
      }
    }
  }
}

void Layout::find_data_cells() {
  // The first block is the top triangle without its right-hand diagonal cell, so that four turns of
  // it cover each cell but the centre exactly once.
  std::vector<CellPosition> block;
  for (int y = 0; y < width_ / 2; ++y) {
    for (int x = y; x <= width_ - 2 - y; ++x) {
      if (cell(x, y) == Cell::Data) block.push_back({x, y});
    }
  }
  for (int turn = 0; turn < 4; ++turn) {
    data_cells_.insert(data_cells_.end(), block.begin(), block.end());
    for (CellPosition& p : block) p = {width_ - 1 - p.y, p.x};
  }
  if (width_ % 2 == 1 && cell(width_ / 2, width_ / 2) == Cell::Data) {
    data_cells_.push_back({width_ / 2, width_ / 2});
  }
  if (data_cells_.empty() || bits() > kMaxBits) {
    throw std::invalid_argument(fmt::format("layout has {} data cells; a codeword has 1 to {} bits",
                                            data_cells_.size(), kMaxBits));
  }
}

void Layout::find_border() {
  // By the fourfold symmetry the top row of a ring stands for the whole ring.
  const auto ring_is = [this](int ring, Cell colour) {
    for (int x = ring; x < width_ - ring; ++x) {
      if (cell(x, ring) != colour) return false;
    }
    return true;
  };
  for (int ring = 0; 2 * (ring + 1) < width_; ++ring) {
    const bool black_in_white = ring_is(ring, Cell::White) && ring_is(ring + 1, Cell::Black);
    const bool white_in_black = ring_is(ring, Cell::Black) && ring_is(ring + 1, Cell::White);
    if (black_in_white || white_in_black) {
      border_offset_ = ring + 1;
      reversed_border_ = white_in_black;
      return;
    }
  }
  throw std::invalid_argument(
      "layout has no border: a whole ring of black cells next to a whole ring of white cells is "
      "what a detector finds");
}

}  // namespace tagmint::codec
