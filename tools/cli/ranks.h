#pragma once

#include "cluster/launcher.h"

namespace tagmint::cli {

/// run_program() in a process that a launcher (mpirun, srun) started among others. When all of them
/// were given the same command line they are one program: the first one runs it, the others work
/// for its searches and end with its exit code. Otherwise each runs its own command line by itself.
int run_program_on_ranks(const cluster::Launch& launch, int argc, const char* const* argv);

}  // namespace tagmint::cli
