#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint check`: proves what a family declares, from its codes alone.
Command check_command();

}  // namespace tagmint::cli
