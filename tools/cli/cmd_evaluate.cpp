#include "cli/cmd_evaluate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "cli/html/trial_page.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/process.h"
#include "cli/progress.h"
#include "cli/seed_option.h"
#include "cli/shell_word.h"
#include "cli/standard_output.h"
#include "cli/terminal.h"
#include "evaluate/family_trial.h"
#include "evaluate/peers.h"
#include "evaluate/photographs.h"
#include "evaluate/run.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::cli {
namespace {

using evaluate::ExperimentKind;

struct Options {
  std::string experiment;
  std::string family;
  std::string folder;
  std::vector<std::string> photographs;
  std::uint64_t seed = 1;
  int samples = 0;
  bool quick = false;
  bool restart = false;
  bool no_peers = false;
};

const ExperimentKind& find_kind(const std::string& name) {
  std::vector<std::string> names;
  for (const ExperimentKind& kind : evaluate::experiment_kinds()) {
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  const std::string hint = codec::did_you_mean(name, names);
  throw UsageError(fmt::format("there is no experiment '{}'", name), "EXPERIMENT",
                   hint.empty() ? "'tagmint evaluate' lists them" : hint);
}

int list_experiments() {
  std::string text;
  for (const ExperimentKind& kind : evaluate::experiment_kinds()) {
    text += fmt::format("{:<16} {}\n", kind.name, kind.summary);
  }
  write_stdout(text);
  return kDone;
}

evaluate::Settings settings_of(const Options& options, const Common& common) {
  evaluate::Settings settings;
  settings.seed = options.seed;
  settings.quick = options.quick;
  settings.samples = options.samples;
  settings.own_family = !options.family.empty();
  settings.family = codec::load_family(options.family.empty() ? "tag36h11" : options.family);
  settings.threads = common.threads > 0
                         ? common.threads
                         : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  settings.photographs = evaluate::find_photographs(options.photographs);
  settings.contenders = evaluate::own_contenders();
  if (!options.no_peers) {
    evaluate::Peers peers = evaluate::find_peers();
    for (evaluate::ContenderKind& kind : peers.kinds) {
      settings.contenders.push_back(std::move(kind));
    }
    for (const std::string& line : peers.left_out) say(common, "goes without " + line);
  }
  return settings;
}

evaluate::Outcome run_with_progress(const ExperimentKind& kind, const evaluate::Settings& settings,
                                    const Options& options, const Common& common) {
  Progress progress(common, std::string(kind.name), "points");
  const InterruptGuard interrupt;
  evaluate::RunOptions run{.folder = options.folder, .restart = options.restart};
  run.stop = interrupt.token();
  run.going_on = [&](std::size_t known, std::size_t total) {
    say(common, fmt::format("going on after {} of {} points", known, total));
  };
  bool begun = false;
  run.progress = [&](double done, double total, const std::string& point) {
    if (!begun) progress.restart(done);
    begun = true;
    progress.update(done, total, point);
  };
  try {
    return run_experiment(kind, settings, run);
  } catch (const evaluate::Stopped&) {
    progress.clear();
    interrupt.throw_if_interrupted("the finished points are kept: the same command goes on");
    throw;
  }
}

/// The page of a family beside tag36h11.
int run_trial(const Options& options, const Common& common) {
  const evaluate::Settings settings = settings_of(options, common);
  const evaluate::Outcome outcome =
      run_with_progress(evaluate::family_trial_kind(), settings, options, common);
  const std::filesystem::path page =
      std::filesystem::path(options.folder) / (settings.family->name() + ".html");
  const std::string command =
      fmt::format("tagmint evaluate --family {}{} --seed {} -o DIR", shell_word(options.family),
                  options.quick ? " --quick" : "", options.seed);
  write_output(page.string(), trial_page(*settings.family, outcome, outcome.conditions, command));
  write_stdout(outcome.summary);
  say(common, "written to " + page.string());
  return kDone;
}

int run(const Options& options, const Common& common) {
  if (options.experiment.empty()) {
    return options.family.empty() ? list_experiments() : run_trial(options, common);
  }
  const ExperimentKind& kind = find_kind(options.experiment);
  const evaluate::Settings settings = settings_of(options, common);
  const evaluate::Outcome outcome = run_with_progress(kind, settings, options, common);
  write_stdout(outcome.summary);
  for (const std::filesystem::path& file : outcome.files) {
    say(common, "written to " + file.string());
  }
  return kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "Without arguments it lists the experiments; with --family alone it writes a page about that "
      "family, FAMILY.html. Each writes NAME.csv (its head explains the "
      "columns), NAME.svg and NAME.png, and a summary to stdout. A run that was ended goes on when "
      "it is started again. libapriltag and OpenCV take part where they are found.");
  auto options = std::make_shared<Options>();
  app.add_option("EXPERIMENT", options->experiment, "what to run");
  app.add_option("-o,--output", options->folder, "folder for the results")
      ->type_name("DIR")
      ->default_val(".");
  app.add_option("--family", options->family, "family to show and look for")
      ->type_name("FAMILY")
      ->default_str("tag36h11");
  app.add_flag("--quick", options->quick, "a minute's worth of pictures");
  add_seed(app, options->seed);
  app.add_option("--samples", options->samples, "pictures a point, instead of the usual number")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000))
      ->default_str("by experiment");
  app.add_option("--photographs", options->photographs,
                 "folder of pictures without tags (false-positives, timing); again for more")
      ->type_name("FOLDER")
      ->allow_extra_args(false);
  app.add_flag("--restart", options->restart, "begin anew what an earlier run left");
  app.add_flag("--no-peers", options->no_peers, "without libapriltag and OpenCV");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command evaluate_command() {
  return {.name = "evaluate",
          .summary = "rerun the paper's experiments, and ours",
          .examples = {"tagmint evaluate distance --quick -o results",
                       "tagmint evaluate --family my.json -o results"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
