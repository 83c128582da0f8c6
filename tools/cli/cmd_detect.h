#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint detect`: finds tags in images.
Command detect_command();

}  // namespace tagmint::cli
