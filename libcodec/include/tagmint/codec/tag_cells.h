#pragma once

#include <string>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// One tag as it is drawn: a square of cells that are Cell::Black, Cell::White or Cell::None.
class TAGMINT_API TagCells {
 public:
  /// `cells`: row-major, width * width of them.
  TagCells(int width, std::vector<Cell> cells) : width_(width), cells_(std::move(cells)) {}

  int width() const { return width_; }
  /// 0 <= x, y < width().
  Cell at(int x, int y) const { return cells_[static_cast<std::size_t>(y) * width_ + x]; }
  /// One string a row, of 'b', 'w' and 'x'.
  std::vector<std::string> rows() const;

  friend bool operator==(const TagCells&, const TagCells&) = default;

 private:
  int width_;
  std::vector<Cell> cells_;
};

/// The picture of `word` in `layout`: the only description that drawing, rendering and tests use. A
/// 1 bit is white.
TAGMINT_API TagCells tag_cells(const Layout& layout, Codeword word);

/// The word whose picture `cells` is. The inverse of tag_cells(); fixed cells are not looked at.
/// Throws std::invalid_argument when the widths differ or a data cell is Cell::None.
TAGMINT_API Codeword codeword_of(const Layout& layout, const TagCells& cells);

}  // namespace tagmint::codec
