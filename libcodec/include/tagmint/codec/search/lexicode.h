#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/search/crew.h"
#include "tagmint/codec/search/order.h"
#include "tagmint/codec/search/search_state.h"

namespace tagmint::codec {

/// Where a running search stands.
struct TAGMINT_API SearchProgress {
  SearchPhase phase = SearchPhase::Walk;
  int phases = 1;  ///< 1: a walk to the end; 3: docs/lexicodes.md
  /// Words walked, words of the space listed, or words of the walk that the choice has passed; and
  /// how many there will be as far as can be told.
  double phase_done = 0;
  double phase_total = 0;
  /// Words of the walk that are judged, or the like part of the work; never falls.
  std::uint64_t words_done = 0;
  double words_total = 0;  ///< 2^bits, or limit_words
  std::size_t codes = 0;
  double elapsed_s = 0;
};

struct TAGMINT_API LexicodeOptions {
  Layout layout;
  int min_hamming = 0;
  Order order = {};
  Complexity complexity = {};
  /// Stop after this many words of the walk.
  std::optional<std::uint64_t> limit_words = std::nullopt;
  /// Stop when this many codes are found.
  std::optional<std::size_t> limit_codes = std::nullopt;
  /// Stop at the end of the round that passes it.
  std::optional<std::chrono::duration<double>> time_limit = std::nullopt;
  /// 0 = all cores.
  int threads = 0;
  /// Asks the search to end early.
  std::stop_token stop = {};
  /// Called from the calling thread, a few times a second.
  std::function<void(const SearchProgress&)> progress = {};
  /// Called from the calling thread after each round, a few times a second: what a SearchState must
  /// apply() to be able to go on from here.
  std::function<void(const SearchStep&)> step = {};
  /// Who does the work; nothing = local_crew().
  CrewMaker crew = {};
};

/// The part of the options that decides what is found, limits apart.
TAGMINT_API SearchRules rules_of(const LexicodeOptions& options);

/// Why a search ended.
enum class SearchEnd { Complete, LimitWords, LimitCodes, TimeLimit, Stopped };

struct TAGMINT_API LexicodeResult {
  std::vector<Codeword> codewords;   ///< in the order found, in codeword order of bits
  std::uint64_t words_searched = 0;  ///< walk positions 1 .. this were judged (2^64 is given as 0)
  SearchEnd end = SearchEnd::Complete;
};

/// The greedy lexicode (docs/lexicodes.md): walk all words in `order`; take a word when its own
/// four turns are pairwise min_hamming apart, it is min_hamming away from all turns of all words
/// taken, and it is complex enough. The result depends on layout, distance, order and complexity
/// alone, never on threads, on the crew, or on interruptions. Short walks are gone word by word,
/// long ones through a tree of all words (docs/lexicodes.md).
///   start    where an earlier search by the same rules had come to
///   errors   std::invalid_argument for a distance outside 1..bits, and for limits that `start` has
///            already passed
///   cost     processor time of complete searches: 25 bits half a second, 36 bits 2 to 15 s, 41
///            bits a minute, beyond about 45 bits hours
///   memory   8 bytes for each of up to 2^26 tags that are still possible, 0.3 GB, and some 20 MB a
///            thread
TAGMINT_API LexicodeResult search_lexicode(const LexicodeOptions& options, SearchState start = {});

/// The family that a finished search gives; `name` empty = "tag" + layout prefix + bits + "h" +
/// distance. Throws std::invalid_argument when no code was found.
TAGMINT_API Family make_family(const LexicodeOptions& options, const LexicodeResult& result,
                               std::string name = {});

}  // namespace tagmint::codec
