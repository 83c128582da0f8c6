#include "cli/commands.h"

#include <vector>


namespace tagmint::cli {

std::span<const Command> command_table() {
  // One line a command, and its header above.
  // clang-format off
  static const std::vector<Command> table = {
  };
  // clang-format on
  return table;
}

}  // namespace tagmint::cli
