#include "io/family_kinds/data_square.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::io {

using codec::CellPosition;
using codec::Codeword;
using codec::Layout;

bool DataSquare::fits(const Layout& layout, int border) {
  const int side = layout.width() - 2 * border - 2;
  return side >= 1 && side * side == layout.bits() && layout == square_layout(side, border);
}

DataSquare::DataSquare(const Layout& layout)
    : side_(static_cast<int>(std::lround(std::sqrt(layout.bits())))) {
  const int first = (layout.width() - side_) / 2;
  for (const CellPosition cell : layout.data_cells()) {
    place_.push_back((cell.y - first) * side_ + cell.x - first);
  }
}

std::string DataSquare::characters(Codeword word) const {
  std::string text(place_.size(), '0');
  for (std::size_t i = 0; i < place_.size(); ++i) {
    if (word >> (place_.size() - 1 - i) & 1) text[static_cast<std::size_t>(place_[i])] = '1';
  }
  return text;
}

Codeword DataSquare::codeword(std::string_view characters) const {
  assert(characters.size() == place_.size());
  Codeword word = 0;
  for (const int place : place_) {
    word = word << 1 | (characters[static_cast<std::size_t>(place)] == '1');
  }
  return word;
}

Codeword DataSquare::codeword_of_rows(Codeword rows) const {
  Codeword word = 0;
  for (const int place : place_) word = word << 1 | (rows >> (cells() - 1 - place) & 1);
  return word;
}

Codeword DataSquare::rows_of(Codeword word) const {
  Codeword rows = 0;
  for (std::size_t i = 0; i < place_.size(); ++i) {
    rows |= (word >> (place_.size() - 1 - i) & 1) << (cells() - 1 - place_[i]);
  }
  return rows;
}

Layout square_layout(int side, int border) {
  constexpr int kMostSide = 8;
  if (side < 1 || side > kMostSide || border < 1 || border > codec::kMaxBits) {
    throw std::invalid_argument(fmt::format(
        "a data square of {0} x {0} cells in a border of {1} cannot be; sides are 1 to {2}", side,
        border, kMostSide));
  }
  const int width = side + 2 * border + 2;
  std::string rows;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      const int ring = std::min({x, y, width - 1 - x, width - 1 - y});
      rows += static_cast<char>(ring == 0        ? codec::Cell::White
                                : ring <= border ? codec::Cell::Black
                                                 : codec::Cell::Data);
    }
  }
  return Layout(rows);
}

void require_square(const codec::Family& family, std::string_view kind) {
  if (DataSquare::fits(family.layout())) return;
  const std::string layout = codec::layout_name(family.layout());
  throw std::invalid_argument(fmt::format(
      "{} holds full squares of data cells inside a one-cell black border only, the layout of {} "
      "is {}; use apriltag-c, png, csv or tagmint",
      kind, family.name(), layout.starts_with("custom") ? "custom" : layout));
}

}  // namespace tagmint::io
