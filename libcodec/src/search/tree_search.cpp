#include <algorithm>
#include <cmath>
#include <utility>

#include "search/engines.h"
#include "search/open_choice.h"
#include "search/open_listing.h"
#include "search/search_run.h"
#include "search/tree_order.h"
#include "search/walk_scan.h"

namespace tagmint::codec {
namespace {

/// Phase 1 goes on until the open tags to be expected cost less time than has been spent on the
/// walk, and fit the memory.
class ScanLength {
 public:
  ScanLength(const TreeSearchTuning& tuning, int bits) : tuning_(tuning), bits_(bits) {}

  bool enough(const SearchState& state, double open_share) const {
    const std::uint64_t walked = state.words_walked;
    return walked >= least(state) && open_tags(open_share) <= half_of_memory() &&
           open_tags(open_share) * tuning_.words_per_open_tag <= static_cast<double>(walked);
  }

  /// When it will be enough, as the number of open words falls as one over the words walked.
  double expected(const SearchState& state, double open_share) const {
    const double open_by_walked = open_tags(open_share) * static_cast<double>(state.words_walked);
    return std::max({static_cast<double>(least(state)), open_by_walked / half_of_memory(),
                     std::sqrt(open_by_walked * tuning_.words_per_open_tag)});
  }

 private:
  std::uint64_t least(const SearchState& state) const {
    return std::max(tuning_.least_scanned, state.walk_at_least);
  }
  double open_tags(double open_share) const { return std::ldexp(open_share, bits_ - 2); }
  double half_of_memory() const { return static_cast<double>(tuning_.most_open) / 2; }

  const TreeSearchTuning& tuning_;
  int bits_;
};

/// Phase 1. Returns why the search is over, nothing when it is time for phase 2.
std::optional<SearchEnd> walk_far_enough(SearchRun& run, const ScanLength& length) {
  WalkScan scan(run, 3);
  const SearchState& state = run.state();
  do {
    if (const auto end = scan.step()) return end;
    scan.expect(std::min(run.words_total(), length.expected(state, scan.open_share())));
  } while (!length.enough(state, scan.open_share()));
  return std::nullopt;
}

}  // namespace

bool tree_search_possible(int bits) { return bits >= TreeOrder::kLeastBits && bits < kMaxBits; }

LexicodeResult search_by_tree(const LexicodeOptions& options, const TreeSearchTuning& tuning,
                              SearchState start) {
  SearchRun run(options, std::move(start));
  const ScanLength length(tuning, run.bits());
  const SearchState& state = run.state();
  // A search whose steps are kept can go on with an unfinished list another time.
  const bool may_give_up = !options.step;
  while (state.phase != SearchPhase::Choose) {
    if (state.phase == SearchPhase::Walk) {
      if (const auto end = walk_far_enough(run, length)) {
        return run.result(*end, state.words_walked);
      }
    }
    const ListingEnd listing = list_open_tags(run, tuning.most_open, may_give_up);
    if (listing == ListingEnd::Done) break;
    if (listing == ListingEnd::MustStop) {
      return run.result(*run.control().must_end(), state.words_walked);
    }
    run.advance({SearchPhase::Walk, state.words_walked, {}});
  }
  return choose_among_open(run, tuning.most_positions);
}

}  // namespace tagmint::codec
