// The place of ranks.cpp in a program that was built without MPI.
#include <fmt/format.h>

#include "cli/program.h"
#include "cli/ranks.h"
#include "cli/terminal.h"

namespace tagmint::cli {

int run_program_on_ranks(const cluster::Launch& launch, int argc, const char* const* argv) {
  if (launch.rank == 0) {
    say({}, fmt::format("built without MPI: the {} processes do not work together", launch.ranks));
  }
  return run_program(argc, argv);
}

}  // namespace tagmint::cli
