#pragma once

#include <string>
#include <vector>

#include "board/board.h"

namespace tagmint::board {

/// Ids as a list of ranges, "0-5, 9"; ascending.
std::string format_ids(std::vector<codec::TagId> ids);

/// What is printed beside a board, line by line: for each family and size the ids, edge and outer
/// side, for a grid its spacing, and how to print.
std::vector<std::string> board_notes(const Board& board);

}  // namespace tagmint::board
