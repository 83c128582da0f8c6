// The place of ranks.cpp in a program that was built without MPI.
#include "cli/program.h"
#include "cli/ranks.h"

namespace tagmint::cli {

int run_program_on_ranks(const cluster::Launch& launch, int argc, const char* const* argv) {
  return run_program(argc, argv, strangers(launch));
}

}  // namespace tagmint::cli
