#include <algorithm>
#include <cmath>

#include "search/engines.h"
#include "search/open_positions.h"
#include "search/parallel.h"
#include "search/round_pacer.h"
#include "search/tree_order.h"
#include "search/walk_scan.h"

namespace tagmint::codec {
namespace {

/// Phase 1 goes on until the open tags to be expected cost less time than has been spent on the
/// walk, and fit the memory.
class ScanLength {
 public:
  ScanLength(const TreeSearchTuning& tuning, int bits)
      : tuning_(tuning), least_(tuning.least_scanned), bits_(bits) {}

  bool enough(const WalkScan& scan) const {
    const auto scanned = static_cast<double>(scan.words_done());
    const double open_tags = std::ldexp(scan.open_share(), bits_ - 2);
    return scan.words_done() >= least_ && open_tags <= static_cast<double>(tuning_.most_open) / 2 &&
           open_tags * tuning_.words_per_open_tag <= scanned;
  }

  /// The tree was tried in vain.
  void demand_more(const WalkScan& scan) { least_ = 2 * scan.words_done(); }

 private:
  const TreeSearchTuning& tuning_;
  std::uint64_t least_;
  int bits_;
};

OpenPositions list_rest(WalkScan& scan, const TreeSearchTuning& tuning) {
  return list_open_positions({.walk = scan.walk(),
                              .codewords = scan.greedy().codewords(),
                              .min_hamming = scan.options().min_hamming,
                              .after = scan.words_done(),
                              .last = scan.last_index(),
                              .most = tuning.most_open,
                              .threads = thread_count(scan.options().threads),
                              .paint_radius = tuning.paint_radius},
                             scan.control());
}

/// `share`: part of phase 3 that is done.
void report(WalkScan& scan, double share) {
  const double behind = scan.words_total() - static_cast<double>(scan.words_done());
  const double done = kListingShareOfProgress + (1 - kListingShareOfProgress) * share;
  scan.control().report(scan.words_done() + static_cast<std::uint64_t>(done * behind),
                        scan.words_total(), scan.greedy().codewords().size());
}

/// Phase 3: the greedy choice among the words at `positions`.
LexicodeResult choose_among(WalkScan& scan, const std::vector<std::uint64_t>& positions) {
  const auto source = [&](std::uint64_t first, std::span<Codeword> words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      words[i] = scan.walk().visited(positions[first + i]);
    }
  };
  Greedy& greedy = scan.greedy();
  greedy.assume_distant_from_present_codes();
  RoundPacer pacer;
  std::uint64_t next = 0;
  std::optional<SearchEnd> end;
  while (next < positions.size() && !(end = scan.control().must_end())) {
    const std::uint64_t count = std::min<std::uint64_t>(pacer.words(), positions.size() - next);
    const auto before = scan.control().elapsed();
    const Greedy::Round round = greedy.judge(source, next, count, scan.max_codes());
    pacer.learn(round, scan.control().elapsed() - before);
    next += round.judged;
    report(scan, static_cast<double>(next) / static_cast<double>(positions.size()));
    if (greedy.codewords().size() >= scan.max_codes()) {
      end = SearchEnd::LimitCodes;
      break;
    }
  }
  const std::uint64_t done = next > 0 ? positions[next - 1] : scan.words_done();
  if (end) return {greedy.codewords(), done, *end};
  return {greedy.codewords(), scan.last_index() + 1, scan.end_of_words()};
}

}  // namespace

bool tree_search_possible(int bits) { return bits >= TreeOrder::kLeastBits && bits < kMaxBits; }

LexicodeResult search_by_tree(const LexicodeOptions& options, const TreeSearchTuning& tuning) {
  WalkScan scan(options);
  ScanLength length(tuning, options.layout.bits());
  while (true) {
    if (const auto end = scan.step()) return scan.result(*end);
    if (!length.enough(scan)) continue;
    const OpenPositions open = list_rest(scan, tuning);
    if (open.end == OpenPositions::End::Done) return choose_among(scan, open.positions);
    length.demand_more(scan);
  }
}

}  // namespace tagmint::codec
