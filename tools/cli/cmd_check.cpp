#include "cli/cmd_check.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/family_input.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/process.h"
#include "cli/progress.h"
#include "cli/terminal.h"
#include "tagmint/codec/family_check.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/search/completeness.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string family;
  std::string from;
  std::optional<int> min_hamming;
  bool complete = false;
  std::string output;
};

/// Goes through all words, with progress and Ctrl-C.
codec::Completeness prove(const codec::Family& family, const Common& common) {
  InterruptGuard guard;
  Progress progress(common, "proof", "words");
  const codec::CompletenessOptions options{
      .threads = common.threads,
      .stop = guard.token(),
      .progress = [&](double done, double total) { progress.update(done, total); },
      .crew = common.crew};
  const codec::Completeness proven = codec::prove_complete(family, options);
  progress.clear();
  if (proven.stopped) guard.throw_if_interrupted("nothing was proven");
  return proven;
}

/// "0x... could be added: 11 bits from tag 0, the nearest one, 12 from its own turns".
std::string addable_text(const codec::Family& family, codec::Codeword word) {
  const auto distance = [&](codec::Codeword code) {
    return codec::rotation_distance(word, code, family.bits());
  };
  const std::vector<codec::Codeword> codes = codec::first_codewords(family, family.size());
  const auto nearest = std::min_element(codes.begin(), codes.end(),
                                        [&](auto a, auto b) { return distance(a) < distance(b); });
  return fmt::format(
      "{} could be added: it is {} bits from tag {}, the nearest, {} from its own "
      "turns, and complex enough",
      codec::to_hex(word), distance(*nearest), nearest - codes.begin(),
      codec::self_distance(word, family.bits()));
}

/// What a family is proven to be, line by line, and what breaks its word.
struct Findings {
  std::vector<std::string> proven;
  std::string violation;  // empty = none
};

Findings findings_of(const codec::Family& family, bool complete, const Common& common) {
  codec::FamilyCheck check = codec::check_family(family, common.threads);
  if (check.violation) return {std::move(check.proven), check.violation->message};
  Findings findings{std::move(check.proven), {}};
  if (!complete) return findings;
  if (const auto addable = prove(family, common).addable) {
    findings.violation = "not complete, " + addable_text(family, *addable);
  } else {
    findings.proven.push_back(
        fmt::format("complete, none of all 2^{} words could be added", family.bits()));
  }
  return findings;
}

int run(const Options& options, const Common& common) {
  const InputFamily input = read_input_family(
      options.family, {.min_hamming = options.min_hamming, .threads = common.threads},
      options.from);
  const codec::SharedFamily& family = input.family;
  for (const std::string& note : input.notes) {
    say(common, fmt::format("{}: {}", family->name(), note));
  }
  const Findings findings = findings_of(*family, options.complete, common);
  std::string text;
  for (const std::string& line : findings.proven) {
    text += fmt::format("{}: proven: {}\n", family->name(), line);
  }
  if (!findings.violation.empty()) {
    text += fmt::format("{}: VIOLATION: {}\n", family->name(), findings.violation);
  }
  write_output(options.output, text);
  return findings.violation.empty() ? kDone : kAnswerIsNo;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "Proves distance, distance to the own turns, complexity and levels from the codes alone. "
      "Exit code 1 where something does not hold.");
  auto options = std::make_shared<Options>();
  add_any_family(app, options->family, options->from);
  add_output(app, options->output);
  app.add_option("--min-hamming", options->min_hamming,
                 "distance to prove, of a family whose file declares none")
      ->type_name("H")
      ->check(CLI::Range(1, codec::kMaxBits))
      ->default_str("computed");
  app.add_flag("--complete", options->complete,
               "prove too that no further word could be added; seconds at 36 bits, hours at 48");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command check_command() {
  return {.name = "check",
          .summary = "prove what a family declares, or show what is wrong",
          .examples = {"tagmint check tag36h11 --complete", "tagmint check my.json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
