#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "search/search_control.h"
#include "tagmint/codec/search/crew.h"
#include "tagmint/codec/search/lexicode.h"
#include "tagmint/codec/search/order.h"
#include "tagmint/codec/search/search_state.h"

namespace tagmint::codec {

/// The rules of a search. Throws std::invalid_argument for a distance outside 1..bits.
SearchRules checked_rules(const LexicodeOptions& options);

/// What the phases of one search share: its limits, how far it is, and who works on it.
class SearchRun {
 public:
  /// `options` must outlive the object. Throws std::invalid_argument as search_lexicode().
  SearchRun(const LexicodeOptions& options, SearchState start);
  /// With a crew that keeps the rules of `options`.
  SearchRun(const LexicodeOptions& options, SearchState start, std::unique_ptr<SearchCrew> crew);

  const LexicodeOptions& options() const { return options_; }
  const Walk& walk() const { return walk_; }
  const SearchState& state() const { return state_; }
  SearchControl& control() { return control_; }
  SearchCrew& crew() { return *crew_; }

  int bits() const { return walk_.bits(); }
  /// Index of the last word that the search is to judge; index 0 is walk position 1.
  std::uint64_t last_index() const { return last_; }
  double words_total() const { return static_cast<double>(last_) + 1; }
  /// How the search ends when it has judged the last word.
  SearchEnd end_of_words() const;
  /// Codes that may still be taken.
  std::size_t codes_left() const;

  /// Hands over the open tags, once phase 2 is done; the state is without them from then on.
  std::vector<Codeword> take_open_tags() { return std::exchange(state_.open_tags, {}); }

  /// Room for `count` open tags, so that they are never copied while they grow in number; what is
  /// not used costs no memory.
  void reserve_open_tags(std::size_t count);

  /// Takes one step on, and tells the caller.
  void advance(const SearchStep& step);

  /// The result as it stands, of which walk positions 1 .. `words` are judged.
  LexicodeResult result(SearchEnd end, std::uint64_t words) const {
    return {state_.codewords, words, end};
  }

 private:
  const LexicodeOptions& options_;
  SearchControl control_;
  Walk walk_;
  std::unique_ptr<SearchCrew> crew_;
  SearchState state_;
  std::uint64_t last_;
};

}  // namespace tagmint::codec
