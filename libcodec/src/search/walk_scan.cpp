#include "search/walk_scan.h"

#include <algorithm>

namespace tagmint::codec {
namespace {

constexpr std::uint64_t kFewestWords = 256;
/// Hundredths of a second of work. With 40,000 codes of 48 bits a word costs 29 ns in rounds of
/// 2^20 words, 17 in rounds of 2^22 and 8 in rounds of 2^25.
constexpr std::uint64_t kWorthwhileWords = std::uint64_t{1} << 22;
constexpr std::uint64_t kMostWords = std::uint64_t{1} << 30;

}  // namespace

WalkScan::WalkScan(SearchRun& run, int phases)
    : run_(run),
      phases_(phases),
      pacer_(kFewestWords, kWorthwhileWords, kMostWords),
      words_expected_(run.words_total()) {}

std::optional<SearchEnd> WalkScan::step() {
  constexpr std::size_t kOverlapsForFree = 16;
  if (run_.options().limit_words == 0) return SearchEnd::LimitWords;
  if (run_.codes_left() == 0) return SearchEnd::LimitCodes;
  const std::uint64_t done = run_.state().words_walked;
  if (done == run_.last_index() + 1 && done != 0) return run_.end_of_words();
  if (const auto end = run_.control().must_end()) return end;

  const std::uint64_t beyond_first = run_.last_index() - done;  // left but one: 2^64 do not fit
  const std::uint64_t count = std::min(pacer_.pieces() - 1, beyond_first) + 1;
  const auto before = run_.control().elapsed();
  const SiftedWords sifted = run_.crew().sift(done, count);
  const Round round = choose_greedily(sifted, run_.bits(), run_.options().min_hamming, done, count,
                                      run_.codes_left());
  run_.advance({SearchPhase::Walk, done + round.judged, round.taken});
  pacer_.learn(run_.control().elapsed() - before, run_.crew().round_length(),
               round.overlapping > kOverlapsForFree + round.taken.size());
  remember(round.judged, sifted.distant);

  const SearchState& state = run_.state();
  run_.control().report({.phase = SearchPhase::Walk,
                         .phases = phases_,
                         .phase_done = static_cast<double>(state.words_walked),
                         .phase_total = words_expected_,
                         .words_done = state.words_walked,
                         .words_total = run_.words_total(),
                         .codes = state.codewords.size()});
  if (run_.codes_left() == 0) return SearchEnd::LimitCodes;
  if (state.words_walked == run_.last_index() + 1) return run_.end_of_words();
  return std::nullopt;
}

void WalkScan::remember(std::uint64_t judged, std::uint64_t distant) {
  constexpr double kOpenWordsRemembered = 60;  // a recent share, right to some 15 per cent
  if (recent_open_ > kOpenWordsRemembered) {
    recent_open_ /= 2;
    recent_words_ /= 2;
  }
  recent_words_ += static_cast<double>(judged);
  recent_open_ += static_cast<double>(distant);
}

}  // namespace tagmint::codec
