#pragma once

#include <string>
#include <vector>

#include "board/board.h"
#include "draw/canvas.h"

namespace tagmint::board {

/// A board on a page; lengths in mm from the page's top-left corner.
struct BoardPage {
  double width_mm = 0.0;
  double height_mm = 0.0;
  draw::Box board;                 ///< where the board's extent stands
  draw::Box notes;                 ///< where ruler and notes stand
  std::vector<std::string> lines;  ///< of the notes; none = neither notes nor ruler
};

/// A page as large as the board, a margin around it, and the height of the notes below.
///   lines   of the notes, may be empty
/// Throws draw::DoesNotFit for a page larger than draw::kMaxPageMm, std::invalid_argument for a
/// margin that is negative.
BoardPage page_of_own_size(const Board& board, double margin_mm, std::vector<std::string> lines);

/// A given paper with the board in the middle of what margin and notes leave free. Throws
/// draw::DoesNotFit where that is too little, and says what would do; std::invalid_argument for a
/// side or margin out of range.
BoardPage page_on_paper(const Board& board, double width_mm, double height_mm, double margin_mm,
                        std::vector<std::string> lines);

/// Draws the board and its notes.
void draw_board(draw::Canvas& canvas, const Board& board, const BoardPage& page);

/// What of the page is white, for files that are shown on other grounds: all of it but the holes in
/// tags, where the layout has no cell and no other tag stands.
draw::Path white_ground(const Board& board, const BoardPage& page);

}  // namespace tagmint::board
