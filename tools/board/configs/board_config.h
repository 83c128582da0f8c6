#pragma once

#include <span>
#include <string>
#include <string_view>

#include "board/board.h"
#include "tagmint/codec/errors.h"

namespace tagmint::board {

/// Kinds of files that tell other programs where the tags of a board are.
enum class ConfigKind { Kalibr, Ros1, Ros2, Wpilib, Tagmint };

/// "kalibr", "ros1", "ros2", "wpilib", "tagmint": in the order of the kinds.
std::span<const std::string> config_kind_names();

/// The name of a kind.
const std::string& name_of(ConfigKind kind);

/// A kind of file has no way to say what the board is; the message says what and why.
class NotExpressible : public codec::Fault {
 public:
  using Fault::Fault;
};

/// The content of a file of that kind; lengths in metres, exact to 1e-12 m. Frames and their axes:
/// docs/boards.md.
/// Throws NotExpressible.
std::string board_config(ConfigKind kind, const Board& board);

}  // namespace tagmint::board
