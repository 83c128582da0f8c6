#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint info`: statistics of a family.
Command info_command();

}  // namespace tagmint::cli
