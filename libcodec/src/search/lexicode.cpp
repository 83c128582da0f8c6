#include "tagmint/codec/search/lexicode.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "search/engines.h"
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

}  // namespace

LexicodeResult search_plain(const LexicodeOptions& options) {
  WalkScan scan(options);
  std::optional<SearchEnd> end;
  while (!end) end = scan.step();
  return scan.result(*end);
}

LexicodeResult search_lexicode(const LexicodeOptions& options) { return search_plain(options); }

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
