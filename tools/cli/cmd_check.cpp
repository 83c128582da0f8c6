#include "cli/cmd_check.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/options.h"
#include "cli/output.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_check.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string family;
  std::string output;
};

int run(const Options& options, const Common& common) {
  const codec::SharedFamily family = codec::load_family(options.family);
  const codec::FamilyCheck check = codec::check_family(*family, common.threads);
  std::string text;
  for (const std::string& line : check.proven) {
    text += fmt::format("{}: proven: {}\n", family->name(), line);
  }
  if (check.violation) {
    text += fmt::format("{}: VIOLATION: {}\n", family->name(), check.violation->message);
  }
  write_output(options.output, text);
  return check.violation ? kAnswerIsNo : kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "Proves distance, distance to the own turns, complexity and levels from the codes alone. "
      "Exit code 1 where something does not hold.");
  auto options = std::make_shared<Options>();
  add_family(app, options->family);
  add_output(app, options->output);
  add_absent_option(app, "--complete", "leave it out to check the codes themselves");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command check_command() {
  return {.name = "check",
          .summary = "prove what a family declares, or show what is wrong",
          .examples = {"tagmint check tag36h11", "tagmint check my.json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
