#include "tagmint/codec/search/lexicode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "search/engines.h"
#include "search/local_crew.h"
#include "search/search_run.h"
#include "search/walk_scan.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/version.h"

namespace tagmint::codec {
namespace {

std::string searched_text(const LexicodeResult& result, int bits) {
  if (result.end == SearchEnd::Complete) return "complete";
  const double share = std::ldexp(static_cast<double>(result.words_searched), -bits);
  return fmt::format("the first {} words of the walk ({:.4g} %)", result.words_searched,
                     100 * share);
}

/// Whether so many words are to be visited that a walk through all of them would take longer than
/// finding out which of them matter.
bool tree_pays(const LexicodeOptions& options) {
  constexpr double kLeastWords = 1 << 28;  // about two seconds of the plain search
  const int bits = options.layout.bits();
  if (!tree_search_possible(bits)) return false;
  const double all = std::ldexp(1.0, bits);
  const double wanted =
      options.limit_words ? std::min(static_cast<double>(*options.limit_words), all) : all;
  // The tree goes through the whole space, at a few hundredths of the walk's time for a word.
  return wanted >= kLeastWords && wanted >= all / 64;
}

/// Every word of the walk, one round after the other.
LexicodeResult walk_through(SearchRun& run) {
  WalkScan scan(run);
  std::optional<SearchEnd> end;
  while (!end) end = scan.step();
  return run.result(*end, run.state().words_walked);
}

}  // namespace

LexicodeResult search_plain(const LexicodeOptions& options, SearchState start) {
  const SearchRules rules = checked_rules(options);
  SearchRun run(options, std::move(start),
                std::make_unique<LocalCrew>(rules, options.threads,
                                            LocalCrewTuning{.walk_by_groups = false}));
  return walk_through(run);
}

LexicodeResult search_by_walk(const LexicodeOptions& options, SearchState start) {
  SearchRun run(options, std::move(start));
  return walk_through(run);
}

LexicodeResult search_lexicode(const LexicodeOptions& options, SearchState start) {
  const bool tree_begun = start.phase != SearchPhase::Walk;
  return tree_begun || tree_pays(options) ? search_by_tree(options, {}, std::move(start))
                                          : search_by_walk(options, std::move(start));
}

Family make_family(const LexicodeOptions& options, const LexicodeResult& result, std::string name) {
  if (result.codewords.empty()) {
    throw std::invalid_argument(
        fmt::format("the search found no code of {} bits at distance {}; a smaller distance, a "
                    "milder complexity rule or a longer search may find some",
                    options.layout.bits(), options.min_hamming));
  }
  if (name.empty()) {
    name = fmt::format("tag{}{}h{}", layout_family_prefix(options.layout), options.layout.bits(),
                       options.min_hamming);
  }
  const std::int64_t seed =
      walk_seed(options.order, options.layout, options.min_hamming, options.complexity);
  return Family({.name = std::move(name),
                 .layout = options.layout,
                 .min_hamming = options.min_hamming,
                 .codewords = result.codewords,
                 .complexity = options.complexity,
                 .origin = {.method = "lexicode",
                            .order = to_string(options.order),
                            .seed = std::to_string(seed),
                            .searched = searched_text(result, options.layout.bits()),
                            .program = fmt::format("tagmint {}", kVersion)},
                 .levels = {}});
}

}  // namespace tagmint::codec
