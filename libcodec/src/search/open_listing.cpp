#include "search/open_listing.h"

#include <algorithm>
#include <cmath>

#include "search/round_pacer.h"

namespace tagmint::codec {
namespace {

constexpr std::uint64_t kFewestSubtrees = 1;
constexpr std::uint64_t kWorthwhileSubtrees = 16;
constexpr std::uint64_t kMostSubtrees = std::uint64_t{1} << 22;

void report(SearchRun& run, double share) {
  const SearchState& state = run.state();
  const double behind = run.words_total() - static_cast<double>(state.words_walked);
  const double words = std::ldexp(1.0, run.bits());
  run.control().report(
      {.phase = SearchPhase::List,
       .phases = 3,
       .phase_done = share * words,
       .phase_total = words,
       .words_done = state.words_walked +
                     static_cast<std::uint64_t>(kListingShareOfProgress * share * behind),
       .words_total = run.words_total(),
       .codes = state.codewords.size()});
}

}  // namespace

ListingEnd list_open_tags(SearchRun& run, std::size_t most, bool may_give_up) {
  constexpr double kSample = 0.01;  // enough subtrees to foretell the rest
  const SearchState& state = run.state();
  const std::uint64_t subtrees = subtree_count(run.bits());
  const std::uint64_t first = state.subtrees_listed;
  run.reserve_open_tags(most);
  const auto started = run.control().elapsed();
  RoundPacer pacer(kFewestSubtrees, kWorthwhileSubtrees, kMostSubtrees);
  while (state.subtrees_listed < subtrees) {
    if (run.control().must_end()) return ListingEnd::MustStop;
    const std::uint64_t begin = state.subtrees_listed;
    const std::uint64_t count = std::min(pacer.pieces(), subtrees - begin);
    const auto before = run.control().elapsed();
    const std::vector<Codeword> open = run.crew().list_open(begin, count);
    if (state.open_tags.size() + open.size() > most) return ListingEnd::TooMany;
    run.advance({SearchPhase::List, begin + count, open});
    pacer.learn(run.control().elapsed() - before, run.crew().round_length());

    report(run, static_cast<double>(begin + count) / static_cast<double>(subtrees));
    const double done = static_cast<double>(begin + count - first);
    const double left = static_cast<double>(subtrees - begin - count);
    const auto time_left = run.control().time_left();
    if (!may_give_up || !time_left || done < kSample * static_cast<double>(subtrees)) continue;
    if ((run.control().elapsed() - started) * (left / done) > *time_left) {
      return ListingEnd::TooSlow;
    }
  }
  return ListingEnd::Done;
}

}  // namespace tagmint::codec
