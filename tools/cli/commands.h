#pragma once

#include <span>

#include "cli/command.h"

namespace tagmint::cli {

/// All subcommands, in the order of `tagmint --help`.
std::span<const Command> command_table();

}  // namespace tagmint::cli
