#pragma once

#include <span>
#include <string>

#include "manual/option_table.h"

namespace tagmint::manual {

/// tagmint.1: the program as a whole.
std::string program_page(std::span<const CommandEntry> table);

/// tagmint-COMMAND.1, in the man macros of troff.
std::string command_page(const CommandEntry& command);

/// Completion scripts: commands, options, and values where there is anything to offer.
std::string bash_completion(std::span<const CommandEntry> table);
std::string zsh_completion(std::span<const CommandEntry> table);
std::string fish_completion(std::span<const CommandEntry> table);

}  // namespace tagmint::manual
