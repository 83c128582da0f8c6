#pragma once

#include <optional>

#include "search/greedy.h"
#include "search/round_pacer.h"
#include "search/search_run.h"

namespace tagmint::codec {

/// Phase 1, and the whole of a plain search: every word of the walk, one after the other.
class WalkScan {
 public:
  /// `run` must outlive the object; `phases` of the whole search, for the reports.
  explicit WalkScan(SearchRun& run, int phases = 1);

  /// Judges one round of words. Returns why the search is over, nothing while it is not.
  std::optional<SearchEnd> step();

  /// Share of the words of the latest rounds that no code excluded and that lie far enough from
  /// their own turns, as an average in which older rounds fade; one more, as a guess on the safe
  /// side where few words were seen.
  double open_share() const { return recent_words_ > 0 ? (recent_open_ + 1) / recent_words_ : 1.0; }

  /// For the progress reports: how many words the walk is going to take.
  void expect(double words) { words_expected_ = words; }

 private:
  void remember(std::uint64_t judged, std::uint64_t distant);

  SearchRun& run_;
  int phases_;
  RoundPacer pacer_;
  double words_expected_;
  double recent_words_ = 0;
  double recent_open_ = 0;
};

}  // namespace tagmint::codec
