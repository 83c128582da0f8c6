#pragma once

#include <string>

#include "board/board_page.h"
#include "draw/file_canvas.h"

namespace tagmint::board {

/// A board on its page as the content of a file. Throws codec::OutputError where it cannot be
/// drawn.
std::string board_file(const Board& board, const BoardPage& page, draw::FileKind kind,
                       const draw::FileOptions& options);

}  // namespace tagmint::board
