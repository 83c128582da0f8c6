#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/layout.h"

namespace tagmint::io {

/// The data cells of a classic layout as other programs list them: a square of side x side cells,
/// row by row from the top left.
class DataSquare {
 public:
  /// Whether the layout is such a square inside a border of black cells.
  ///   border   cells from the data to the border square, all black
  static bool fits(const codec::Layout& layout, int border = 1);

  /// The layout must fit.
  explicit DataSquare(const codec::Layout& layout);

  int side() const { return side_; }
  int cells() const { return side_ * side_; }
  /// One character a cell: '1' is white, '0' is black.
  std::string characters(codec::Codeword word) const;
  /// The inverse; `characters` are cells() of '0' and '1'.
  codec::Codeword codeword(std::string_view characters) const;
  /// The codeword whose cells, row by row, are the bits of `rows`: the most significant of its
  /// cells() low bits is the top left cell.
  codec::Codeword codeword_of_rows(codec::Codeword rows) const;
  /// The inverse of codeword_of_rows().
  codec::Codeword rows_of(codec::Codeword word) const;

 private:
  int side_;
  std::vector<int> place_;  // of each bit of a codeword, from the most significant: y * side + x
};

/// The layout with a data square of that side, a border of `border` black cells around it and a
/// white ring. Throws std::invalid_argument for a side outside 1..8 or a border below 1.
codec::Layout square_layout(int side, int border = 1);

/// Throws std::invalid_argument with the reason unless the family fits a kind of files that holds
/// data squares inside a one-cell border only.
///   kind   as the message has it, "an OpenCV dictionary"
void require_square(const codec::Family& family, std::string_view kind);

}  // namespace tagmint::io
