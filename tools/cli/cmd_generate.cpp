#include "cli/cmd_generate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "cli/duration.h"
#include "cli/generate_plan.h"
#include "cli/number.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/process.h"
#include "cli/progress.h"
#include "cli/terminal.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::cli {
namespace {

using codec::LexicodeOptions;
using codec::LexicodeResult;
using codec::SearchEnd;

constexpr int kMostAttempts = 1'000'000;

struct Options {
  std::string layout;
  int min_hamming = 0;
  std::string method = "lexicode";
  std::string complexity;
  std::string order;
  int attempts = 1;
  std::string limit_codes;
  std::string limit_words;
  std::string time_limit;
  std::string name;
  std::string output;
};

/// The search that the options ask for; every fault of an option is told before it starts.
LexicodeOptions plan_search(const Options& options, const Common& common) {
  const codec::Layout layout = parse_option(
      [](std::string_view text) { return codec::parse_layout(text); }, options.layout, "--layout");
  if (options.min_hamming > layout.bits()) {
    throw UsageError(fmt::format("distance {} is not possible with the layout's {} bits",
                                 options.min_hamming, layout.bits()),
                     "--min-hamming", fmt::format("ask for 1 to {}", layout.bits()));
  }
  LexicodeOptions search{.layout = layout,
                         .min_hamming = options.min_hamming,
                         .order = default_order(layout),
                         .complexity = default_complexity(layout),
                         .limit_words = std::nullopt,
                         .limit_codes = std::nullopt,
                         .time_limit = std::nullopt,
                         .threads = common.threads,
                         .stop = {},
                         .progress = {}};
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
void require_family_name(const std::string& name, const LexicodeOptions& search) {
  if (name.empty()) return;
  try {
    codec::Family({name, search.layout, search.min_hamming, {codec::Codeword{0}}, {}, {}, {}});
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

std::string end_text(const LexicodeResult& result, const LexicodeOptions& search) {
  const std::string words = fmt::format("after {} words", result.words_searched);
  switch (result.end) {
    case SearchEnd::Complete:
      return fmt::format("all 2^{} words searched", search.layout.bits());
    case SearchEnd::LimitWords:
      return words + " (--limit-words)";
    case SearchEnd::LimitCodes:
      return words + " (--limit-codes)";
    case SearchEnd::TimeLimit:
      return words + " (--time-limit)";
    case SearchEnd::Stopped:
      break;
  }
  return words;
}

struct Attempt {
  LexicodeOptions search;
  LexicodeResult result;
};

/// Runs the searches one after the other and keeps the one with the most codes, the first on ties.
class Attempts {
 public:
  Attempts(LexicodeOptions search, int count, const Common& common)
      : search_(std::move(search)), count_(count), common_(common), deadline_(deadline()) {}

  Attempt best() {
    const std::vector<codec::Order> orders = attempt_orders(
        search_.order, search_.layout, search_.min_hamming, search_.complexity, count_);
    std::optional<Attempt> best;
    for (std::size_t i = 0; i < orders.size(); ++i) {
      if (best && time_is_up()) {
        say(common_, fmt::format("{} of {} attempts made (--time-limit)", i, count_));
        break;
      }
      Attempt attempt = run(i, orders[i]);
      if (!best || attempt.result.codewords.size() > best->result.codewords.size()) {
        best = std::move(attempt);
      }
    }
    return std::move(*best);
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<Clock::time_point> deadline() const {
    if (!search_.time_limit) return std::nullopt;
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(*search_.time_limit);
  }

  bool time_is_up() const { return deadline_ && Clock::now() >= *deadline_; }

  Attempt run(std::size_t index, const codec::Order& order) {
    Attempt attempt{search_, {}};
    attempt.search.order = order;
    attempt.search.stop = guard_.token();
    if (deadline_) {
      attempt.search.time_limit = std::chrono::duration<double>(*deadline_ - Clock::now());
    }
    Progress progress(common_, "search", "words");
    const std::string label =
        count_ > 1 ? fmt::format("attempt {} of {}, ", index + 1, count_) : std::string();
    attempt.search.progress = [&](const codec::SearchProgress& state) {
      progress.update(static_cast<double>(state.words_done), state.words_total,
                      fmt::format("{}{} codes", label, state.codes));
    };
    attempt.result = codec::search_lexicode(attempt.search);
    progress.clear();
    guard_.throw_if_interrupted("nothing was written; give --time-limit to keep what is found");
    if (count_ > 1) {
      say(common_,
          fmt::format("{}{}: {} codes, {}", label, codec::to_string(order),
                      attempt.result.codewords.size(), end_text(attempt.result, attempt.search)));
    }
    attempt.search.progress = nullptr;
    return attempt;
  }

  LexicodeOptions search_;
  int count_;
  const Common& common_;
  std::optional<Clock::time_point> deadline_;
  InterruptGuard guard_;
};

int run(const Options& options, const Common& common) {
  if (options.method != "lexicode") {
    throw UsageError(fmt::format("the method {} is not part of this version", options.method),
                     "--method", "use lexicode");
  }
  const LexicodeOptions search = plan_search(options, common);
  require_family_name(options.name, search);
  require_family_file(options.output);
  const Attempt best = Attempts(search, options.attempts, common).best();
  if (best.result.codewords.empty()) {
    print_error(
        fmt::format("no code found, {} (--layout, --min-hamming); ask for a smaller "
                    "distance or complexity, or search more words",
                    end_text(best.result, best.search)));
    return kAnswerIsNo;
  }
  const codec::Family family = codec::make_family(best.search, best.result, options.name);
  write_output(options.output, codec::format_family(family));
  say(common, fmt::format("{}: {} codes, order {}, {}{}", family.name(), family.size(),
                          codec::to_string(best.search.order), end_text(best.result, best.search),
                          is_stdout(options.output) ? "" : "; written to " + options.output));
  return kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "The tags are H bits apart in every rotation. What is found does not depend on the number of "
      "threads.");
  auto options = std::make_shared<Options>();
  app.add_option("--layout", options->layout, "classic:W, standard:W, circle:W or custom:ROWS")
      ->required()
      ->type_name("LAYOUT");
  app.add_option("--min-hamming", options->min_hamming,
                 "least distance between any two tags in any rotation, in bits")
      ->required()
      ->type_name("H")
      ->default_str("")
      ->check(CLI::Range(1, codec::kMaxBits));
  add_choice(app, "--method", options->method, {"lexicode", "rotation-code"}, "how to search")
      ->type_name("lexicode");  // rotation-code is refused below
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
  add_absent_option(app, "--checkpoint", "bound the search with --time-limit instead");
  add_absent_option(app, "--resume", "start the search from its beginning");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command generate_command() {
  return {.name = "generate",
          .summary = "search a new family of tags",
          .examples = {"tagmint generate --layout standard:7 --min-hamming 9 -o my.json",
                       "tagmint generate --layout classic:8 --min-hamming 5 --attempts 20 -o "
                       "best.json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
