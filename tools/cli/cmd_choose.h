#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint choose`: which family, level and ids suit a use.
Command choose_command();

}  // namespace tagmint::cli
