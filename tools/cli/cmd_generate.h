#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint generate`: searches a family and writes its file.
Command generate_command();

}  // namespace tagmint::cli
