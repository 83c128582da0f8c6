#pragma once

#include <string_view>

#include "cli/command.h"

namespace CLI {
class ParseError;
}

namespace tagmint::cli {

/// The option or argument that `app` met but does not have, as a usage error with the nearest name;
/// returns normally when there is none. Misspelt options are told before their consequences (a
/// required option that is missing), so call this first after a failed parse.
void throw_if_unknown_option(const CLI::App& app, std::string_view command);

/// What CLI11 found wrong, in our own form.
UsageError usage_error(const CLI::ParseError& error, std::string_view command);

}  // namespace tagmint::cli
