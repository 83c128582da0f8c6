#include "cli/process.h"
#include "cli/program.h"
#include "cli/ranks.h"
#include "cluster/launcher.h"

int main(int argc, char** argv) {
  tagmint::cli::prepare_process();
  const auto launch = tagmint::cluster::read_launch();
  if (launch && launch->ranks != 1) return tagmint::cli::run_program_on_ranks(*launch, argc, argv);
  return tagmint::cli::run_program(argc, argv);
}
