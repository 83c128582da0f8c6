#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint poster`: a tag larger than the paper, over many pages.
Command poster_command();

}  // namespace tagmint::cli
