#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint board`: calibration boards and bundles, and the configs that describe them.
Command board_command();

}  // namespace tagmint::cli
