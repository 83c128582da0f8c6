#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint families`: lists the families that the program carries.
Command families_command();

}  // namespace tagmint::cli
