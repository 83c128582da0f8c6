#pragma once

#include "cli/command.h"
#include "cluster/launcher.h"

namespace tagmint::cli {

/// run_program() in a process that a launcher (mpirun, srun) started among others. When all of them
/// were given the same command line they are one program: the first one runs it, the others work
/// for its searches and end with its exit code. Otherwise each runs its own command line by itself;
/// where they do not find each other, which leaves open whether they were to be one program,
/// searches are refused.
int run_program_on_ranks(const cluster::Launch& launch, int argc, const char* const* argv);

/// The common options of processes that do not find each other.
inline Common strangers(const cluster::Launch& launch) {
  Common common;
  common.processes = launch.ranks;
  return common;
}

}  // namespace tagmint::cli
