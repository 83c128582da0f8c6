#include "pair_distances.h"

#include <algorithm>
#include <atomic>
#include <functional>

#include "search/parallel.h"

namespace tagmint::codec {
namespace {

/// Rows (values of i) that a thread takes at a time: enough to make taking cheap, few enough for
/// an even share, since early rows hold more pairs than late ones.
constexpr std::size_t kRowsAtATime = 16;

/// Calls visit(level index, first j, codewords j of the level) for the pairs (i, j) of row `i`.
template <typename Visit>
void visit_row(std::span<const Codeword> codewords, std::span<const Level> levels, std::size_t i,
               const Visit& visit) {
  std::size_t begin = i + 1;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const std::size_t end = levels[level].codes;
    if (begin >= end) continue;
    visit(level, begin, codewords.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace

std::vector<DistanceHistogram> pair_histograms(std::span<const Codeword> codewords, int bits,
                                               std::span<const Level> levels, int threads) {
  const int workers = thread_count(threads);
  std::vector<std::vector<DistanceHistogram>> parts(
      workers, std::vector<DistanceHistogram>(levels.size(), DistanceHistogram{}));
  std::atomic<std::size_t> next_row{0};
  run_workers(workers, [&](int worker) {
    for (std::size_t row; (row = next_row.fetch_add(kRowsAtATime)) < codewords.size();) {
      for (std::size_t i = row; i < std::min(row + kRowsAtATime, codewords.size()); ++i) {
        const FourTurns turns = four_turns(codewords[i], bits);
        visit_row(codewords, levels, i,
                  [&](std::size_t level, std::size_t, std::span<const Codeword> others) {
                    add_distances(others, turns, parts[worker][level]);
                  });
      }
    }
  });
  std::vector<DistanceHistogram> sum(levels.size(), DistanceHistogram{});
  for (const auto& part : parts) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
      std::transform(part[level].begin(), part[level].end(), sum[level].begin(), sum[level].begin(),
                     std::plus<>());
    }
  }
  return sum;
}

std::optional<std::pair<TagId, TagId>> first_near_pair(std::span<const Codeword> codewords,
                                                       int bits, std::span<const Level> levels,
                                                       int threads) {
  const int workers = thread_count(threads);
  std::vector<std::optional<std::pair<TagId, TagId>>> found(workers);
  std::atomic<std::size_t> next_row{0};
  std::atomic<std::size_t> end_row{codewords.size()};  // rows from here on cannot be the first
  run_workers(workers, [&](int worker) {
    // Rows are handed out in order, so a worker's first find is its lowest.
    for (std::size_t row; !found[worker] && (row = next_row.fetch_add(1)) < end_row.load();) {
      const FourTurns turns = four_turns(codewords[row], bits);
      visit_row(codewords, levels, row,
                [&](std::size_t level, std::size_t begin, std::span<const Codeword> others) {
                  if (found[worker]) return;
                  const std::size_t at = first_within(others, turns, levels[level].min_hamming - 1);
                  if (at == others.size()) return;
                  found[worker] = {static_cast<TagId>(row), static_cast<TagId>(begin + at)};
                });
      if (!found[worker]) continue;
      std::size_t end = end_row.load();
      while (row < end && !end_row.compare_exchange_weak(end, row)) {
      }
    }
  });
  std::optional<std::pair<TagId, TagId>> first;
  for (const auto& pair : found) {
    if (pair && (!first || *pair < *first)) first = pair;
  }
  return first;
}

}  // namespace tagmint::codec
