#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "search/greedy.h"
#include "search/round_pacer.h"
#include "search/search_control.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {

/// The plain search: every word of the walk, one after the other, until a limit or the end. Words
/// are counted from index 0, which is walk position 1.
class WalkScan {
 public:
  /// `options` must outlive the object. Throws std::invalid_argument for a distance
  /// outside 1..bits.
  explicit WalkScan(const LexicodeOptions& options);

  /// Judges one round of words. Returns why the search is over, nothing while it is not.
  std::optional<SearchEnd> step();

  /// What has been found, told as ended by `end`.
  LexicodeResult result(SearchEnd end) const;

  /// Words judged so far.
  std::uint64_t words_done() const { return next_; }
  /// Index of the last word that the search is to judge.
  std::uint64_t last_index() const { return last_; }
  /// How the search ends when it has judged the last word.
  SearchEnd end_of_words() const;
  double words_total() const { return static_cast<double>(last_) + 1; }
  std::size_t max_codes() const { return max_codes_; }
  /// Share of the words of the latest rounds that no code excluded and that lie far enough from
  /// their own turns, as an average in which older rounds fade.
  double open_share() const { return recent_words_ > 0 ? recent_open_ / recent_words_ : 1.0; }

  Greedy& greedy() { return greedy_; }
  const Greedy& greedy() const { return greedy_; }
  const Walk& walk() const { return walk_; }
  SearchControl& control() { return control_; }
  const LexicodeOptions& options() const { return options_; }

 private:
  void remember(const Greedy::Round& round);

  const LexicodeOptions& options_;
  SearchControl control_;
  Walk walk_;
  Greedy greedy_;
  RoundPacer pacer_;
  std::uint64_t next_ = 0;
  std::uint64_t last_ = 0;
  std::size_t max_codes_ = 0;
  double recent_words_ = 0;
  double recent_open_ = 0;
};

}  // namespace tagmint::codec
