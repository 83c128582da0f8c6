#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint convert`: between the kinds of files that hold a family.
Command convert_command();

}  // namespace tagmint::cli
