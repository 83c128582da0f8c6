#pragma once

#include <string_view>

#include "cli/command.h"

namespace tagmint::cli {

/// Whether the file descriptor is a terminal that understands cursor movement (TERM is not "dumb").
bool is_terminal(int descriptor);

/// Whether colour may be used there: a terminal, and NO_COLOR is unset or empty (no-color.org).
bool wants_colour(int descriptor);

/// Width of the terminal in columns; 80 where it cannot be told.
int terminal_columns(int descriptor);

/// Writes "tagmint: LINE" to stderr, unless --quiet was given.
void say(const Common& common, std::string_view line);

/// Writes "tagmint: error: LINE" to stderr, in one line whatever `line` holds.
void print_error(std::string_view line);

}  // namespace tagmint::cli
