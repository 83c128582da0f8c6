#pragma once

#include "tagmint/codec/search/crew.h"

namespace tagmint::cli {

/// The whole program: parses the command line, runs the command, prints faults in one line, returns
/// the exit code.
///   crew   who does the work of searches; nothing = the threads of this process
int run_program(int argc, const char* const* argv, const codec::CrewMaker& crew = {});

}  // namespace tagmint::cli
