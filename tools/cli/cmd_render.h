#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint render`: synthetic camera images with ground truth.
Command render_command();

}  // namespace tagmint::cli
