#include "cli/program.h"

int main(int argc, char** argv) { return tagmint::cli::run_program(argc, argv); }
