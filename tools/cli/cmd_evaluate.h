#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint evaluate`: experiments as tables and figures.
Command evaluate_command();

}  // namespace tagmint::cli
