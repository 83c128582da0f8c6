#include "search/open_choice.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "search/greedy.h"
#include "search/open_listing.h"
#include "search/parallel.h"
#include "search/round_pacer.h"
#include "search/sieve.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

constexpr std::uint64_t kFewestWords = 256;
constexpr std::uint64_t kWorthwhileWords = std::uint64_t{1} << 14;
constexpr std::uint64_t kMostWords = std::uint64_t{1} << 22;
constexpr std::chrono::milliseconds kLongestRound{200};

/// A stretch of the walk: positions after + 1 .. to.
struct Stretch {
  std::uint64_t after = 0;
  std::uint64_t to = 0;
};

/// The number of tags still open falls as one over the words walked. So the walk is gone in
/// stretches, each three times as long as all before, and what the codes of one stretch exclude is
/// forgotten before the next: each holds few words, though the last one is most of the walk.
class OpenChoice {
 public:
  OpenChoice(SearchRun& run, std::size_t most_positions)
      : run_(run),
        most_positions_(most_positions),
        open_(run.take_open_tags()),
        pacer_(kFewestWords, kWorthwhileWords, kMostWords) {}

  LexicodeResult run() {
    const SearchState& state = run_.state();
    // The open tags are far enough from the codes of phase 1.
    forget_near(state.walked_codes);
    std::uint64_t done = std::max(state.words_walked, state.chosen_to);
    while (done < run_.last_index() + 1) {
      // Asked here as well, as there may be no open word in a stretch.
      if (const auto end = run_.control().must_end()) return run_.result(*end, done);
      const Stretch stretch = next(done);
      const std::size_t known = state.codewords.size();
      if (const auto end = choose(positions(stretch))) {
        return run_.result(*end, std::max(done, state.chosen_to));
      }
      done = stretch.to;
      run_.advance({SearchPhase::Choose, done, {}});
      if (done < run_.last_index() + 1) forget_near(known);
    }
    return run_.result(run_.end_of_words(), done);
  }

 private:
  Sieve new_sieve() const {
    return Sieve(rules_of(run_.options()), run_.walk(), thread_count(run_.options().threads));
  }

  /// Forgets the tags that are too near to a code from number `first` on.
  void forget_near(std::size_t first) {
    Sieve sieve = new_sieve();
    sieve.learn(std::span(run_.state().codewords).subspan(first));
    sieve.erase_near(open_, [this] { return run_.control().must_end().has_value(); });
  }

  /// The stretch behind position `after`, with about `most_positions_` open words at most.
  Stretch next(std::uint64_t after) const {
    const double open_words = 4.0 * static_cast<double>(open_.size());
    const double most = std::ldexp(static_cast<double>(most_positions_), run_.bits()) / open_words;
    const double length = std::min(3.0 * static_cast<double>(after) + 1, most);
    const std::uint64_t left = run_.last_index() + 1 - after;
    if (length >= static_cast<double>(left)) return {after, after + left};
    return {after, after + std::clamp<std::uint64_t>(static_cast<std::uint64_t>(length), 1, left)};
  }

  /// Ascending walk positions in the stretch of all turns of the open tags.
  std::vector<std::uint64_t> positions(Stretch stretch) const {
    std::vector<std::uint64_t> positions;
    for (const Codeword tag : open_) {
      for (int turn = 0; turn < 4; ++turn) {
        const std::uint64_t position = run_.walk().position_of(rotate(tag, run_.bits(), turn));
        if (position > stretch.after && position <= stretch.to) positions.push_back(position);
      }
    }
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
  }

  /// The choice among the words at `positions`, which are far enough from all codes before. Returns
  /// why the search is over, nothing while it is not.
  std::optional<SearchEnd> choose(const std::vector<std::uint64_t>& positions) {
    const auto source = [&](std::uint64_t first, std::span<Codeword> words) {
      for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = run_.walk().visited(positions[first + i]);
      }
    };
    Sieve sieve = new_sieve();
    for (std::uint64_t next = 0; next < positions.size();) {
      if (run_.codes_left() == 0) return SearchEnd::LimitCodes;
      if (const auto end = run_.control().must_end()) return end;
      const std::uint64_t count = std::min<std::uint64_t>(pacer_.pieces(), positions.size() - next);
      const auto before = run_.control().elapsed();
      const SiftedWords sifted = sieve.sift(source, next, count);
      const Round round = choose_greedily(sifted, run_.bits(), run_.options().min_hamming, next,
                                          count, run_.codes_left());
      sieve.learn(round.taken);
      pacer_.learn(run_.control().elapsed() - before, kLongestRound,
                   round.overlapping > round.taken.size() + 16);
      next += round.judged;
      run_.advance({SearchPhase::Choose, positions[next - 1], round.taken});
      report();
    }
    if (run_.codes_left() == 0) return SearchEnd::LimitCodes;
    return std::nullopt;
  }

  void report() {
    const SearchState& state = run_.state();
    const double behind = run_.words_total() - static_cast<double>(state.words_walked);
    const double chosen = static_cast<double>(state.chosen_to - state.words_walked);
    const double share =
        kListingShareOfProgress + (1 - kListingShareOfProgress) * chosen / std::max(behind, 1.0);
    run_.control().report(
        {.phase = SearchPhase::Choose,
         .phases = 3,
         .phase_done = chosen,
         .phase_total = behind,
         .words_done = state.words_walked + static_cast<std::uint64_t>(share * behind),
         .words_total = run_.words_total(),
         .codes = state.codewords.size()});
  }

  SearchRun& run_;
  std::size_t most_positions_;
  std::vector<Codeword> open_;
  RoundPacer pacer_;
};

}  // namespace

LexicodeResult choose_among_open(SearchRun& run, std::size_t most_positions) {
  return OpenChoice(run, most_positions).run();
}

}  // namespace tagmint::codec
