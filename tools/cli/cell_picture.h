#pragma once

#include <string>

#include "tagmint/codec/tag_cells.h"

namespace tagmint::cli {

/// A tag as lines of text (UTF-8), two characters a cell so that cells look square: full blocks for
/// white, spaces for black, middle dots where the tag has no cell.
std::string cell_picture(const codec::TagCells& cells);

}  // namespace tagmint::cli
