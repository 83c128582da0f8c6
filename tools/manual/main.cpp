// tagmint_manual DIR: writes DIR/man/*.1 and the completion scripts for bash, zsh and fish.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <vector>

#include "manual/option_table.h"
#include "manual/writers.h"
#include "tagmint/codec/atomic_file.h"
#include "tagmint/codec/errors.h"

int main(int argc, char** argv) try {
  namespace manual = tagmint::manual;
  using tagmint::codec::write_file_atomically;
  if (argc != 2) {
    fmt::print(stderr, "usage: tagmint_manual DIR\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder / "man");
  const std::vector<manual::CommandEntry> table = manual::option_table();
  write_file_atomically(folder / "man" / "tagmint.1", manual::program_page(table));
  for (const manual::CommandEntry& command : table) {
    write_file_atomically(folder / "man" / fmt::format("tagmint-{}.1", command.name),
                          manual::command_page(command));
  }
  write_file_atomically(folder / "_tagmint", manual::zsh_completion(table));
  write_file_atomically(folder / "tagmint.fish", manual::fish_completion(table));
  write_file_atomically(folder / "tagmint.bash", manual::bash_completion(table));
  return 0;
} catch (const std::exception& fault) {
  fmt::print(stderr, "tagmint_manual: error: {}\n", fault.what());
  return 4;
}
