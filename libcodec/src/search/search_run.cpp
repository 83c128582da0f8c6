#include "search/search_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tagmint::codec {
namespace {

void require_reachable_limits(const LexicodeOptions& options, const SearchState& start) {
  const std::uint64_t judged = std::max(start.words_walked, start.chosen_to);
  if (options.limit_words && *options.limit_words < judged) {
    throw std::invalid_argument(
        fmt::format("the search has already gone {} words far, beyond the limit of {} words",
                    judged, *options.limit_words));
  }
  if (options.limit_codes && *options.limit_codes < start.codewords.size()) {
    throw std::invalid_argument(
        fmt::format("the search has already found {} codes, more than the limit of {} codes",
                    start.codewords.size(), *options.limit_codes));
  }
}

std::unique_ptr<SearchCrew> crew_for(const LexicodeOptions& options) {
  const SearchRules rules = checked_rules(options);
  return options.crew ? options.crew(rules, options.threads) : local_crew(rules, options.threads);
}

}  // namespace

SearchRules rules_of(const LexicodeOptions& options) {
  return {options.layout, options.min_hamming, options.order, options.complexity};
}

SearchRules checked_rules(const LexicodeOptions& options) {
  const int bits = options.layout.bits();
  if (options.min_hamming < 1 || options.min_hamming > bits) {
    throw std::invalid_argument(
        fmt::format("minimum Hamming distance {} is not possible with {} bits; 1 to {} are",
                    options.min_hamming, bits, bits));
  }
  return rules_of(options);
}

SearchRun::SearchRun(const LexicodeOptions& options, SearchState start)
    : SearchRun(options, std::move(start), crew_for(options)) {}

SearchRun::SearchRun(const LexicodeOptions& options, SearchState start,
                     std::unique_ptr<SearchCrew> crew)
    : options_(options),
      control_(options),
      walk_(options.layout, options.order,
            walk_seed(options.order, options.layout, options.min_hamming, options.complexity)),
      crew_(std::move(crew)),
      state_(std::move(start)),
      last_(low_mask(options.layout.bits())) {
  require_reachable_limits(options, state_);
  if (options.limit_words && *options.limit_words <= last_) last_ = *options.limit_words - 1;
  crew_->learn(std::span(state_.codewords).first(state_.walked_codes));
}

SearchEnd SearchRun::end_of_words() const {
  return last_ == low_mask(bits()) ? SearchEnd::Complete : SearchEnd::LimitWords;
}

std::size_t SearchRun::codes_left() const {
  if (!options_.limit_codes) return std::numeric_limits<std::size_t>::max();
  return *options_.limit_codes - std::min(*options_.limit_codes, state_.codewords.size());
}

void SearchRun::reserve_open_tags(std::size_t count) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 26;  // 512 MiB of addresses
  state_.open_tags.reserve(std::min({std::uint64_t{count}, low_mask(bits()), kMost}));
}

void SearchRun::advance(const SearchStep& step) {
  state_.apply(step);
  if (step.phase == SearchPhase::Walk) crew_->learn(step.words);
  if (options_.step) options_.step(step);
}

}  // namespace tagmint::codec
