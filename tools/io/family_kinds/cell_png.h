#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/codec/layout.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::io {

/// A rectangle of cells that are Cell::Black, Cell::White or Cell::None; row-major.
struct CellPicture {
  int width = 0;
  int height = 0;
  std::vector<codec::Cell> cells;
};

/// The picture as a gray PNG file of one pixel a cell, with transparency where a cell is none.
std::string encode_cell_png(const CellPicture& picture);

/// The tag that such a file shows, of any colour type.
///   source   name used in messages
/// Throws codec::InputError: no PNG or a damaged one, not square, wider than a layout can be, a
/// pixel that is neither black nor white nor transparent.
codec::TagCells decode_cell_png(std::string_view bytes, const std::string& source);

}  // namespace tagmint::io
