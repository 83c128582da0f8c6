#include "cli/cmd_info.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/family_input.h"
#include "cli/family_report.h"
#include "cli/html/family_page.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/shell_word.h"
#include "cli/terminal.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string family;
  std::string from;
  std::string format;
  std::string output;
  std::string html;
};

/// Whether the text or JSON is wanted: always, unless the page alone was asked for.
bool wants_text(const Options& options) {
  return options.html.empty() || !options.format.empty() || !options.output.empty();
}

void write_page(const FamilyReport& report, const InputFamily& input, const Options& options,
                const Common& common) {
  const std::string converted = report.family->name() + ".json";
  write_output(options.html, input.foreign
                                 ? family_page(report, converted,
                                               fmt::format("tagmint convert {} -o {}",
                                                           shell_word(options.family), converted))
                                 : family_page(report, options.family, ""));
  if (!is_stdout(options.html)) {
    say(common, fmt::format("{}: the page of {} tags; written to {}", report.family->name(),
                            report.family->size(), options.html));
  }
}

int run(const Options& options, const Common& common) {
  const std::vector<std::string> formats = {"text", "json"};
  const std::string format = choose_format(options.format, options.output, formats, "text");
  const bool text = wants_text(options);
  if (!options.html.empty()) {
    if (text && is_stdout(options.html) && is_stdout(options.output)) {
      throw UsageError("the page and the text cannot both go to stdout", "--html",
                       "give one of them a file");
    }
    require_writable(options.html);
  }
  const InputFamily input =
      read_input_family(options.family, {.threads = common.threads}, options.from);
  for (const std::string& note : input.notes) {
    say(common, fmt::format("{}: {}", input.family->name(), note));
  }
  const FamilyReport report = make_family_report(input.family, common.threads);
  if (!options.html.empty()) write_page(report, input, options, common);
  if (text) {
    write_output(options.output,
                 format == "json" ? family_report_json(report) : family_report_text(report));
  }
  return kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "Distances between the tags, false accepts, complexity, memory of the lookup; with --html as "
      "one page with charts and all tags, that needs no other file.");
  auto options = std::make_shared<Options>();
  add_any_family(app, options->family, options->from);
  add_format(app, options->format, {"text", "json"}, "text");
  add_output(app, options->output);
  app.add_option("--html", options->html,
                 "write the page to FILE, - is stdout; no text then, unless --format or -o asks")
      ->type_name("FILE");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command info_command() {
  return {.name = "info",
          .summary = "statistics of a family",
          .examples = {"tagmint info my.json --format json",
                       "tagmint info tag36h11 --html tag36h11.html"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
