#pragma once

#include <span>
#include <string>

#include "cli/command.h"

namespace tagmint::cli {

/// What `tagmint --help` prints.
std::string program_help(std::span<const Command> commands);

/// What `tagmint COMMAND --help` prints: usage, options with their defaults, two examples.
///   app   as Command::set_up() left it
std::string command_help(const Command& command, const CLI::App& app);

}  // namespace tagmint::cli
