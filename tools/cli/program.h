#pragma once

#include "cli/command.h"

namespace tagmint::cli {

/// The whole program: parses the command line, runs the command, prints faults in one line, returns
/// the exit code.
///   common   what the common options are where they are not given
int run_program(int argc, const char* const* argv, const Common& common = {});

}  // namespace tagmint::cli
