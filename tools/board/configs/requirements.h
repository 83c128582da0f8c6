#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "board/board.h"

namespace tagmint::board {

/// Names of the families that libapriltag makes, as its users' settings take them.
std::span<const std::string_view> libapriltag_families();

/// Throws NotExpressible unless all tags are of one family with the border that it has in
/// libapriltag. Ids then tell the tags apart.
///   program   whose file it is, for the message
void require_one_plain_family(const Board& board, std::string_view program);

/// Throws NotExpressible unless the board's family is one of libapriltag_families().
void require_libapriltag_family(const Board& board, std::string_view program);

}  // namespace tagmint::board
