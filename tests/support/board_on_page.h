#pragma once

#include "board/board.h"
#include "board/board_page.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::test {

/// From board coordinates to the page, mm.
inline detect::Point on_page(const board::Board& board, const board::BoardPage& page,
                             detect::Point p) {
  return {p.x - board.extent.x_mm + page.board.x_mm, p.y - board.extent.y_mm + page.board.y_mm};
}

inline detect::Corners corners_on_page(const board::Board& board, const board::BoardPage& page,
                                       detect::Corners corners) {
  for (detect::Point& p : corners) p = on_page(board, page, p);
  return corners;
}

}  // namespace tagmint::test
