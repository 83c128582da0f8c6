#include "tagmint/codec/tag_cells.h"

#include <fmt/format.h>

#include <stdexcept>

namespace tagmint::codec {

std::vector<std::string> TagCells::rows() const {
  std::vector<std::string> rows;
  for (int y = 0; y < width_; ++y) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < width_; ++x) row += static_cast<char>(at(x, y));
  }
  return rows;
}

TagCells tag_cells(const Layout& layout, Codeword word) {
  const int width = layout.width();
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(width) * width);
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) cells.push_back(layout.cell(x, y));
  }
  int bit = layout.bits();
  for (const CellPosition p : layout.data_cells()) {
    --bit;
    cells[static_cast<std::size_t>(p.y) * width + p.x] =
        (word >> bit) & 1 ? Cell::White : Cell::Black;
  }
  return TagCells(width, std::move(cells));
}

Codeword codeword_of(const Layout& layout, const TagCells& cells) {
  if (cells.width() != layout.width()) {
    throw std::invalid_argument(
        fmt::format("the picture is {} cells wide, the layout {}", cells.width(), layout.width()));
  }
  Codeword word = 0;
  for (const CellPosition p : layout.data_cells()) {
    const Cell cell = cells.at(p.x, p.y);
    if (cell != Cell::Black && cell != Cell::White) {
      throw std::invalid_argument(
          fmt::format("the data cell in row {}, column {} is neither black nor white", p.y, p.x));
    }
    word = (word << 1) | (cell == Cell::White);
  }
  return word;
}

}  // namespace tagmint::codec
