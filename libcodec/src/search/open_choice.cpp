#include "search/open_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "search/greedy.h"
#include "search/open_listing.h"
#include "search/parallel.h"
#include "search/round_pacer.h"
#include "search/sieve.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

constexpr std::uint64_t kFewestWords = 256;
constexpr std::uint64_t kMostWords = std::uint64_t{1} << 22;

class OpenChoice {
 public:
  OpenChoice(SearchRun& run, std::size_t most_positions)
      : run_(run),
        most_positions_(most_positions),
        sieve_(rules_of(run.options()), run.walk(), thread_count(run.options().threads)),
        pacer_(kFewestWords, kMostWords, std::chrono::milliseconds(200)) {
    // The open words are far enough from the codes of phase 1 already.
    const SearchState& state = run.state();
    sieve_.learn(std::span(state.codewords).subspan(state.walked_codes));
  }

  LexicodeResult run() {
    const SearchState& state = run_.state();
    std::uint64_t after = std::max(state.words_walked, state.chosen_to);
    const std::uint64_t words_left = run_.last_index() + 1 - after;
    const std::uint64_t stretch = stretch_length(words_left);
    while (after < run_.last_index() + 1) {
      const std::uint64_t to = after + std::min(stretch, run_.last_index() + 1 - after);
      if (const auto end = choose(positions(after, to))) {
        return run_.result(*end, std::max(state.words_walked, state.chosen_to));
      }
      after = to;
      run_.advance({SearchPhase::Choose, after, {}});
    }
    return run_.result(run_.end_of_words(), after);
  }

 private:
  /// Words of the walk that hold about `most_positions_` open ones; they lie evenly.
  std::uint64_t stretch_length(std::uint64_t words_left) const {
    const double open = 4.0 * static_cast<double>(run_.state().open_tags.size());
    const double stretches = std::ceil(open / static_cast<double>(most_positions_));
    return words_left / static_cast<std::uint64_t>(std::max(stretches, 1.0)) + 1;
  }

  /// Ascending walk positions in after + 1 .. to of all turns of the open tags.
  std::vector<std::uint64_t> positions(std::uint64_t after, std::uint64_t to) const {
    std::vector<std::uint64_t> positions;
    for (const Codeword tag : run_.state().open_tags) {
      for (int turn = 0; turn < 4; ++turn) {
        const std::uint64_t position = run_.walk().position_of(rotate(tag, run_.bits(), turn));
        if (position > after && position <= to) positions.push_back(position);
      }
    }
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
  }

  /// The choice among the words at `positions`. Returns why the search is over, nothing while it is
  /// not.
  std::optional<SearchEnd> choose(const std::vector<std::uint64_t>& positions) {
    const auto source = [&](std::uint64_t first, std::span<Codeword> words) {
      for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = run_.walk().visited(positions[first + i]);
      }
    };
    for (std::uint64_t next = 0; next < positions.size();) {
      if (run_.codes_left() == 0) return SearchEnd::LimitCodes;
      if (const auto end = run_.control().must_end()) return end;
      const std::uint64_t count = std::min<std::uint64_t>(pacer_.pieces(), positions.size() - next);
      const auto before = run_.control().elapsed();
      const SiftedWords sifted = sieve_.sift(source, next, count);
      const Round round = choose_greedily(sifted, run_.bits(), run_.options().min_hamming, next,
                                          count, run_.codes_left());
      sieve_.learn(round.taken);
      pacer_.learn(run_.control().elapsed() - before, round.overlapping > round.taken.size() + 16);
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
  Sieve sieve_;
  RoundPacer pacer_;
};

}  // namespace

LexicodeResult choose_among_open(SearchRun& run, std::size_t most_positions) {
  return OpenChoice(run, most_positions).run();
}

}  // namespace tagmint::codec
