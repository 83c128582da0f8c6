#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// `tagmint identify`: which tag a picture shows, and what became of it on the way.
Command identify_command();

}  // namespace tagmint::cli
