#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint decode`: codewords to ids.
Command decode_command();

}  // namespace tagmint::cli
