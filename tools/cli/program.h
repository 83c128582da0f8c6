#pragma once

namespace tagmint::cli {

/// The whole program: parses the command line, runs the command, prints faults in one line, returns
/// the exit code.
int run_program(int argc, const char* const* argv);

}  // namespace tagmint::cli
