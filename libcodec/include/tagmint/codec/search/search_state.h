#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// The phases of a lexicode search (docs/lexicodes.md). A plain search has the first one alone.
enum class SearchPhase {
  Walk = 1,  ///< the words one by one, in order
  List,      ///< all words that the codes of phase 1 leave open, in any order
  Choose,    ///< the greedy choice among these, in the order of the walk
};

/// What one round of a search adds to its state.
struct TAGMINT_API SearchStep {
  SearchPhase phase = SearchPhase::Walk;
  /// How far the phase is now: words walked, subtrees listed, walk position up to which the choice
  /// is made.
  std::uint64_t done = 0;
  /// New: codes in the order found (Walk, Choose) or open tags (List).
  std::span<const Codeword> words;
};

/// How far a search is; enough to go on from.
struct TAGMINT_API SearchState {
  SearchPhase phase = SearchPhase::Walk;
  std::uint64_t words_walked = 0;
  std::vector<Codeword> codewords = {};  ///< found so far, in order
  std::size_t walked_codes = 0;          ///< of these, found in phase 1
  std::uint64_t subtrees_listed = 0;
  std::vector<Codeword> open_tags = {};  ///< one turn of each
  std::uint64_t chosen_to = 0;           ///< phase 3: walk position
  /// Phase 2 was tried and given up: phase 1 is to go on to so many words at least.
  std::uint64_t walk_at_least = 0;

  /// Takes one more step. A step of phase 1 after one of phase 2 means that the list was given up.
  void apply(const SearchStep& step);
};

}  // namespace tagmint::codec
