#include "cli/cmd_info.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/family_report.h"
#include "cli/options.h"
#include "cli/output.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string family;
  std::string format;
  std::string output;
};

int run(const Options& options, const Common& common) {
  const std::vector<std::string> formats = {"text", "json"};
  const std::string format = choose_format(options.format, options.output, formats, "text");
  const FamilyReport report =
      make_family_report(codec::load_family(options.family), common.threads);
  write_output(options.output,
               format == "json" ? family_report_json(report) : family_report_text(report));
  return kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description("Distances between the tags, false accepts, complexity, memory of the lookup.");
  auto options = std::make_shared<Options>();
  add_family(app, options->family);
  add_format(app, options->format, {"text", "json"}, "text");
  add_output(app, options->output);
  add_absent_option(app, "--html", "use --format text or json");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command info_command() {
  return {.name = "info",
          .summary = "statistics of a family",
          .examples = {"tagmint info tag36h11", "tagmint info my.json --format json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
