#include "cli/process.h"
#include "cli/program.h"

int main(int argc, char** argv) {
  tagmint::cli::prepare_process();
  return tagmint::cli::run_program(argc, argv);
}
