#pragma once

#include <string>
#include <vector>

#include "board/board.h"

namespace tagmint::board {

/// Ids as a list of ranges, "0-5, 9"; ascending.
std::string format_ids(std::vector<codec::TagId> ids);

/// What a board is, line by line: for each family and size the edge, outer side and ids, for a grid
/// its spacing.
std::vector<std::string> board_facts(const Board& board);

/// What is printed beside a board: the facts, and how to print.
std::vector<std::string> board_notes(const Board& board);

/// The facts as the comments of a YAML file.
std::string fact_comments(const Board& board);

}  // namespace tagmint::board
