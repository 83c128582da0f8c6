#pragma once

#include <string>

#include "board/board.h"

namespace tagmint::board {

/// Each kind's file, as board_config() gives it. All throw NotExpressible.
std::string kalibr_yaml(const Board& board);
std::string ros1_yaml(const Board& board);
std::string ros2_yaml(const Board& board);
std::string wpilib_json(const Board& board);
std::string tagmint_json(const Board& board);

}  // namespace tagmint::board
