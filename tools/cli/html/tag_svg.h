#pragma once

#include <string>

#include "tagmint/codec/family.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::cli {

/// The black areas of a tag as one SVG path in cells: no edge runs between two black cells, so none
/// can show as a seam. "M1 1H9V9H1z...".
std::string black_path(const codec::TagCells& cells);

/// The same of the places that are no cells of the layout; empty where there are none.
std::string blank_path(const codec::Layout& layout);

/// A tag with its quiet zone, one cell of white, as an SVG element of class "tag".
std::string tag_svg(const codec::Family& family, codec::TagId id);

}  // namespace tagmint::cli
