#pragma once

#include <span>
#include <vector>

#include "board/board.h"
#include "draw/nested_tags.h"

namespace tagmint::board {

/// Plans a grid of tags of one family and size. The origin is in the middle of the grid.
///   grid     columns, rows, border_cells at least 1, edge and gap > 0
///   ids      one a place, row by row in the order of the style
///   nested   tags in the holes of each tag, outermost first; the id is that in the first tag and
///            one more in each that follows
/// In the style Plain the tags stand row by row from the top left, and only white is between them;
/// in the style Kalibr row by row from the bottom left, with black squares of the gap's size at all
/// corners of the border squares, as Kalibr's target has them.
/// Throws draw::DoesNotFit for a gap that is too narrow, naming the least, or a nested tag that
/// does not fit its hole; std::invalid_argument for numbers out of range, ids that are not the
/// family's or not as many as places, a tag that occurs twice, and a style or border that needs a
/// black border on white where the layout has none.
Board plan_grid(const codec::SharedFamily& family, const Grid& grid,
                std::span<const codec::TagId> ids,
                std::span<const draw::NestedRequest> nested = {});

}  // namespace tagmint::board
