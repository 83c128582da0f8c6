#pragma once

#include <vector>

#include "tagmint/codec/layout.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::io {

/// The layouts that tags known as pictures only may have: first those of classic, standard and
/// circle of that width whose fixed cells all tags have, the one with the most fixed cells first;
/// last the one whose data cells are those that change from tag to tag, or that a quarter turn
/// takes to such a cell.
///   tags     at least one, all of one width
///   returns  at least one
/// Throws std::invalid_argument when there is none.
std::vector<codec::Layout> possible_layouts(const std::vector<codec::TagCells>& tags);

/// The number of the first tag that differs from the layout in a fixed cell or in where it has
/// cells; the number of tags when none does.
std::size_t first_misfit(const codec::Layout& layout, const std::vector<codec::TagCells>& tags);

}  // namespace tagmint::io
