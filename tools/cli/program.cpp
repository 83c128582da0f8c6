#include "cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/commands.h"
#include "cli/faults.h"
#include "cli/help.h"
#include "cli/options.h"
#include "cli/parse_error.h"
#include "cli/standard_output.h"
#include "tagmint/codec/suggest.h"
#include "tagmint/codec/version.h"

namespace tagmint::cli {
namespace {

bool is_help(const std::string& argument) { return argument == "--help" || argument == "-h"; }

/// Whether the help was asked for among the options of a command; after "--" all are arguments.
bool asks_for_help(const std::vector<std::string>& arguments) {
  const auto end = std::find(arguments.begin(), arguments.end(), "--");
  return std::any_of(arguments.begin(), end, is_help);
}

const Command& find_command(const std::string& name) {
  const std::span<const Command> table = command_table();
  std::vector<std::string> names;
  for (const Command& command : table) {
    if (command.name == name) return command;
    names.emplace_back(command.name);
  }
  const std::string hint = codec::did_you_mean(name, names);
  throw UsageError(fmt::format("unknown command '{}'", name), "",
                   hint.empty() ? "see 'tagmint --help'" : hint);
}

int run_command(const Command& command, std::vector<std::string> arguments, Common common) {
  CLI::App app;
  app.set_help_flag();
  app.option_defaults()->always_capture_default();
  const Runner runner = command.set_up(app, common);
  add_common_options(app, common);
  if (asks_for_help(arguments)) {
    write_stdout(command_help(command, app));
    return kDone;
  }
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    throw_if_unknown_option(app, command.name);
    throw usage_error(error, command.name);
  } catch (...) {
    throw_if_unknown_option(app, command.name);
    throw;
  }
  return runner();
}

int dispatch(std::vector<std::string> arguments, const Common& common) {
  if (arguments.empty()) throw UsageError("no command given", "", "see 'tagmint --help'");
  const std::string first = arguments.front();
  if (is_help(first)) {
    write_stdout(program_help(command_table()));
    return kDone;
  }
  if (first == "--version") {
    write_stdout(fmt::format("tagmint {}\n", codec::kVersion));
    return kDone;
  }
  if (first.starts_with("-")) {
    const std::string hint =
        codec::did_you_mean(first, std::vector<std::string>{"--help", "--version"});
    throw UsageError(fmt::format("unknown option '{}'", first), "",
                     hint.empty() ? "options follow the command; see 'tagmint --help'" : hint);
  }
  const Command& command = find_command(first);
  arguments.erase(arguments.begin());
  return run_command(command, std::move(arguments), common);
}

}  // namespace

int run_program(int argc, const char* const* argv, const Common& common) {
  return report_faults([&] {
    return dispatch(std::vector<std::string>(argv + std::min(argc, 1), argv + argc), common);
  });
}

}  // namespace tagmint::cli
