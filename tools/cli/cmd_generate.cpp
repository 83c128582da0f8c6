#include "cli/cmd_generate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/duration.h"
#include "cli/generate_plan.h"
#include "cli/generate_rotation_code.h"
#include "cli/number.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/search_attempts.h"
#include "cli/terminal.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::cli {
namespace {

using codec::LexicodeOptions;

constexpr int kMostAttempts = 1'000'000;

struct Options {
  std::string layout;
  int min_hamming = 0;
  std::string method = "lexicode";
  std::string complexity;
  std::string order;
  int attempts = 1;
  std::string levels;
  std::string codes;
  std::string limit_codes;
  std::string limit_words;
  std::string time_limit;
  std::string name;
  std::string checkpoint;
  bool resume = false;
  std::string output;
};

/// The layout, which must have room for the distance.
codec::Layout plan_layout(const Options& options) {
  codec::Layout layout = parse_option(
      [](std::string_view text) { return codec::parse_layout(text); }, options.layout, "--layout");
  if (options.min_hamming > layout.bits()) {
    throw UsageError(fmt::format("distance {} is not possible with the layout's {} bits",
                                 options.min_hamming, layout.bits()),
                     "--min-hamming", fmt::format("ask for 1 to {}", layout.bits()));
  }
  return layout;
}

/// The search that the options ask for; every fault of an option is told before it starts.
LexicodeOptions plan_search(const Options& options, const Common& common) {
  const codec::Layout layout = plan_layout(options);
  LexicodeOptions search{.layout = layout,
                         .min_hamming = options.min_hamming,
                         .order = default_order(layout),
                         .complexity = default_complexity(layout),
                         .limit_words = std::nullopt,
                         .limit_codes = std::nullopt,
                         .time_limit = std::nullopt,
                         .threads = common.threads};
  search.crew = common.crew;
  if (!options.complexity.empty()) {
    search.complexity = parse_option(codec::parse_complexity, options.complexity, "--complexity");
  }
  if (!options.order.empty()) {
    search.order = parse_option(codec::parse_order, options.order, "--order");
  }
  if (!options.limit_codes.empty()) {
    search.limit_codes = parse_count(options.limit_codes, "--limit-codes");
  }
  if (!options.limit_words.empty()) {
    search.limit_words = parse_count(options.limit_words, "--limit-words");
  }
  if (!options.time_limit.empty()) {
    search.time_limit = parse_duration(options.time_limit, "--time-limit");
  }
  return search;
}

/// A name that no family may have is told before the search, not after it.
void require_family_name(const std::string& name, const codec::Layout& layout) {
  if (name.empty()) return;
  try {
    codec::Family({name, layout, 1, {codec::Codeword{0}}, {}, {}, {}});
  } catch (const std::invalid_argument& complaint) {
    throw usage_error(complaint, "--name");
  }
}

void require_family_file(const std::string& output) {
  const std::filesystem::path extension = std::filesystem::path(output).extension();
  if (!extension.empty() && extension != ".json") {
    throw UsageError(
        fmt::format("the extension '{}' is not that of a family file", extension.string()),
        "--output", "end the name with .json");
  }
  require_writable(output);
}

std::string crew_text(const Common& common) {
  const int threads = common.threads > 0 ? common.processes * common.threads : common.crew_cores;
  return fmt::format("{} processes with {} threads together", common.processes, threads);
}

/// The checkpoint is removed when the family is written.
void require_two_files(const Options& options) {
  namespace fs = std::filesystem;
  if (options.checkpoint.empty() || is_stdout(options.output)) return;
  if (fs::weakly_canonical(options.checkpoint) != fs::weakly_canonical(options.output)) return;
  throw UsageError("the checkpoint and the family would be the same file", "--checkpoint",
                   "give it another name than --output");
}

/// Options that only the other method has.
void refuse_options(const std::string& method,
                    std::initializer_list<std::pair<std::string, bool>> given) {
  for (const auto& [option, is_given] : given) {
    if (!is_given) continue;
    throw UsageError(fmt::format("--method {} has no {}", method, option), option,
                     "leave it out, or choose the other method");
  }
}

int run_rotation_code(const Options& options, const Common& common) {
  refuse_options(options.method, {{"--limit-codes", !options.limit_codes.empty()},
                                  {"--limit-words", !options.limit_words.empty()},
                                  {"--time-limit", !options.time_limit.empty()},
                                  {"--checkpoint", !options.checkpoint.empty()},
                                  {"--resume", options.resume}});
  const codec::Layout layout = plan_layout(options);
  require_family_name(options.name, layout);
  require_family_file(options.output);
  return generate_rotation_code({.layout = layout,
                                 .min_hamming = options.min_hamming,
                                 .levels = options.levels,
                                 .codes = options.codes,
                                 .complexity = options.complexity,
                                 .order = options.order,
                                 .attempts = options.attempts,
                                 .name = options.name,
                                 .output = options.output},
                                common);
}

int run(const Options& options, const Common& common) {
  if (options.method == "rotation-code") return run_rotation_code(options, common);
  refuse_options(options.method,
                 {{"--levels", !options.levels.empty()}, {"--codes", !options.codes.empty()}});
  const LexicodeOptions search = plan_search(options, common);
  require_family_name(options.name, search.layout);
  require_family_file(options.output);
  if (options.resume && options.checkpoint.empty()) {
    throw UsageError("nothing says where to go on from", "--resume", "give --checkpoint FILE too");
  }
  require_two_files(options);
  if (common.crew) {
    say(common, crew_text(common));
  } else if (common.processes > 1) {
    throw UsageError(
        fmt::format("{} processes were started that do not find each other", common.processes), "",
        "start a tagmint that is built with MPI by mpirun or srun --mpi=pmix; for searches apart, "
        "srun --mpi=none");
  }
  SearchAttempts attempts(search, options.attempts, {options.checkpoint, options.resume}, common);
  const Attempt best = attempts.best();
  if (best.result.codewords.empty()) {
    print_error(
        fmt::format("no code found, {} (--layout, --min-hamming); ask for a smaller "
                    "distance or complexity, or search more words",
                    end_text(best.result, best.search)));
    attempts.put_checkpoint_away();
    return kAnswerIsNo;
  }
  const codec::Family family = codec::make_family(best.search, best.result, options.name);
  write_output(options.output, codec::format_family(family));
  say(common, fmt::format("{}: {} codes, order {}, {}{}", family.name(), family.size(),
                          codec::to_string(best.search.order), end_text(best.result, best.search),
                          is_stdout(options.output) ? "" : "; written to " + options.output));
  const std::string kept = attempts.put_checkpoint_away();
  if (!kept.empty()) say(common, kept);
  return kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "The tags are H bits apart in every rotation, whatever the threads and interruptions. "
      "Memory: "
      "up to 1 GB and 20 MB a thread.");
  auto options = std::make_shared<Options>();
  app.add_option("--layout", options->layout, "classic:W, standard:W, circle:W or custom:ROWS")
      ->required()
      ->type_name("LAYOUT");
  app.add_option("--min-hamming", options->min_hamming, "least distance of tags in any rotation")
      ->required()
      ->type_name("H")
      ->default_str("")
      ->check(CLI::Range(1, codec::kMaxBits));
  add_choice(app, "--method", options->method, {"lexicode", "rotation-code"},
             "rotation-code: more tags");
  app.add_option("--levels", options->levels, "rotation-code: distances of inner levels")
      ->type_name("H1,H2");
  app.add_option("--codes", options->codes, "rotation-code: keep the first N codes")
      ->type_name("N");
  app.add_option("--complexity", options->complexity, "keep plain patterns out")
      ->type_name("rectangles:N|energy:F|none")
      ->default_str("classic: as published; else energy:0.3333");
  app.add_option("--order", options->order, "order in which words are visited")
      ->type_name("apriltag2|apriltag3|seed:N")
      ->default_str("classic: apriltag2; else apriltag3");
  app.add_option("--attempts", options->attempts, "try K seeds, keep the largest family")
      ->type_name("K")
      ->check(CLI::Range(1, kMostAttempts));
  app.add_option("--limit-codes", options->limit_codes, "stop when N codes are found")
      ->type_name("N");
  app.add_option("--limit-words", options->limit_words, "stop after N words, for example 1e9")
      ->type_name("N");
  app.add_option("--time-limit", options->time_limit,
                 "stop after T in all, for example 90s, 1h30min")
      ->type_name("T");
  app.add_option("--name", options->name, "name of the family, else tag<Layout><bits>h<H>")
      ->type_name("N");
  add_output(app, options->output, "family file, .json");
  app.add_option("--checkpoint", options->checkpoint,
                 "keep in FILE, up to 0.6 GB, what --resume needs")
      ->type_name("FILE");
  app.add_flag("--resume", options->resume, "go on from the checkpoint where there is one");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command generate_command() {
  return {.name = "generate",
          .summary = "search a new family of tags",
          .examples = {"tagmint generate --layout standard:7 --min-hamming 9 -o my.json",
                       "tagmint generate --method rotation-code --layout classic:8 "
                       "--min-hamming 5"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
