#pragma once

#include <span>
#include <string>

#include "cli/command.h"

namespace CLI {
class Option;
}

namespace tagmint::cli {

/// What `tagmint --help` prints.
std::string program_help(std::span<const Command> commands);

/// What `tagmint COMMAND --help` prints: usage, options with their defaults, two examples.
///   app   as Command::set_up() left it
std::string command_help(const Command& command, const CLI::App& app);

/// The first lines of that help: what the command does, and "usage: tagmint COMMAND ...".
std::string command_about(const Command& command, const CLI::App& app);
std::string command_usage(const Command& command, const CLI::App& app);

/// The type of an option's value, "FILE"; empty for flags and positionals.
std::string value_type(const CLI::Option& option);

/// The default that the help shows; empty for none.
std::string shown_default(const CLI::Option& option);

}  // namespace tagmint::cli
