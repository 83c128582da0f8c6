#include "cli/commands.h"

#include <vector>

namespace tagmint::cli {

std::span<const Command> command_table() {
  // One line a command, and its header above.
  static const std::vector<Command> table = {};
  return table;
}

}  // namespace tagmint::cli
