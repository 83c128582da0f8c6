#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint encode`: ids to codewords and cell pictures.
Command encode_command();

}  // namespace tagmint::cli
