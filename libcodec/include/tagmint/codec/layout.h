#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// What a place in the tag's grid is; the characters are those of family files.
enum class Cell : char {
  Data = 'd',   ///< carries one bit of the codeword
  Black = 'b',  ///< always black
  White = 'w',  ///< always white
  None = 'x',   ///< not part of the tag: nothing is drawn there
};

/// A place in a tag's grid, counted in cells from the top-left cell of the whole tag; x right, y
/// down.
struct TAGMINT_API CellPosition {
  int x = 0;
  int y = 0;
  friend bool operator==(const CellPosition&, const CellPosition&) = default;
};

/// The square grid of cells of a tag: where data, the fixed border and nothing are. Constant and
/// valid once made.
///
/// A layout looks the same after a quarter turn, holds 1 to 64 data cells, and has a *border
/// square*: the place where a whole ring of black cells meets a whole ring of white cells. That
/// edge is what a detector finds; its side is the
/// `--edge` of every print. Where several rings meet so, the outermost counts.
class TAGMINT_API Layout {
 public:
  /// `rows`: the characters of Cell, row by row, with an optional '/' between rows, for example
  /// "wwwww/wbbbw/wbdbw/wbbbw/wwwww". Throws std::invalid_argument that names the row, the cell or
  /// the ring at fault.
  explicit Layout(std::string_view rows);

  /// Side of the whole tag in cells.
  int width() const { return width_; }
  /// 0 <= x, y < width().
  Cell cell(int x, int y) const { return static_cast<Cell>(cells_[y * width_ + x]); }
  /// The grid as text, one string a row.
  std::vector<std::string> rows() const;

  /// Number of data cells = bits of a codeword.
  int bits() const { return static_cast<int>(data_cells_.size()); }
  /// Data cells in codeword order, most significant bit first: the top triangle row by row, then
  /// its three quarter turns (x, y) -> (width-1-y, x), then the centre cell if it is data.
  std::span<const CellPosition> data_cells() const { return data_cells_; }

  /// Distance in cells from the tag's outer edge to the border square.
  int border_offset() const { return border_offset_; }
  /// Side of the border square in cells.
  int width_at_border() const { return width_ - 2 * border_offset_; }
  /// False: the border square is black on white. True: it is white inside black.
  bool reversed_border() const { return reversed_border_; }

  friend bool operator==(const Layout& a, const Layout& b) { return a.cells_ == b.cells_; }

 private:
  void check_symmetry() const;
  void find_data_cells();
  void find_border();

  int width_ = 0;
  int border_offset_ = 0;
  bool reversed_border_ = false;
  std::string cells_;  // row-major, width_ * width_
  std::vector<CellPosition> data_cells_;
};

}  // namespace tagmint::codec
