#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint sheet`: tags at exact physical size as PDF, SVG or PNG.
Command sheet_command();

}  // namespace tagmint::cli
