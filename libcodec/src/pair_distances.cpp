#include "pair_distances.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>

#include "kernels/nibble_planes.h"
#include "search/parallel.h"

namespace tagmint::codec {
namespace {

/// Rows (values of i) that a thread takes at a time: enough to make taking cheap, few enough for
/// an even share, since early rows hold more pairs than late ones.
constexpr std::size_t kRowsAtATime = 16;

/// Words (values of j) that a thread compares with its rows before it goes on to the next: those
/// stay near in the meantime.
constexpr std::size_t kWordsAtATime = 1024;

/// Calls visit(level index, first j, end of j) for the parts of begin .. end - 1 that lie in one
/// level each.
template <typename Visit>
void visit_levels(std::span<const Level> levels, std::size_t begin, std::size_t end,
                  const Visit& visit) {
  for (std::size_t level = 0; level < levels.size() && begin < end; ++level) {
    const std::size_t level_end = std::min(levels[level].codes, end);
    if (begin >= level_end) continue;
    visit(level, begin, level_end);
    begin = level_end;
  }
}

/// All codewords, as they are and in blocks for whole-block comparisons.
struct ComparedWords {
  std::span<const Codeword> words;
  NibblePlanes planes;
};

/// Adds the distances of the words begin .. end - 1: whole blocks at once, the words before and
/// after them one by one.
void add_range(const ComparedWords& all, std::size_t begin, std::size_t end, const FourTurns& turns,
               DistanceHistogram& histogram) {
  constexpr std::size_t kBlock = NibblePlanes::kBlockWords;
  const std::size_t first_block = (begin + kBlock - 1) / kBlock;
  const std::size_t end_block = end / kBlock;
  if (first_block >= end_block) {
    add_distances(all.words.subspan(begin, end - begin), turns, histogram);
    return;
  }
  const std::size_t blocks_begin = first_block * kBlock;
  const std::size_t blocks_end = end_block * kBlock;
  add_distances(all.words.subspan(begin, blocks_begin - begin), turns, histogram);
  add_block_distances(all.planes, first_block, end_block, turns, histogram);
  add_distances(all.words.subspan(blocks_end, end - blocks_end), turns, histogram);
}

}  // namespace

std::vector<DistanceHistogram> pair_histograms(std::span<const Codeword> codewords, int bits,
                                               std::span<const Level> levels, int threads) {
  const int workers = thread_count(threads);
  const std::size_t size = codewords.size();
  const ComparedWords all{codewords, NibblePlanes(codewords, bits)};
  std::vector<std::vector<DistanceHistogram>> parts(
      workers, std::vector<DistanceHistogram>(levels.size(), DistanceHistogram{}));
  std::atomic<std::size_t> next_row{0};
  run_workers(workers, [&](int worker) {
    std::array<FourTurns, kRowsAtATime> turns{};
    for (std::size_t row; (row = next_row.fetch_add(kRowsAtATime)) < size;) {
      const std::size_t row_end = std::min(row + kRowsAtATime, size);
      for (std::size_t i = row; i < row_end; ++i) turns[i - row] = four_turns(codewords[i], bits);
      for (std::size_t begin = row, end = 0; begin < size; begin = end) {
        // Up to a multiple, so that no block is cut.
        end = std::min((begin / kWordsAtATime + 1) * kWordsAtATime, size);
        for (std::size_t i = row; i < row_end; ++i) {
          visit_levels(levels, std::max(begin, i + 1), end,
                       [&](std::size_t level, std::size_t first, std::size_t last) {
                         add_range(all, first, last, turns[i - row], parts[worker][level]);
                       });
        }
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
      visit_levels(levels, row + 1, codewords.size(),
                   [&](std::size_t level, std::size_t begin, std::size_t end) {
                     if (found[worker]) return;
                     const auto others = codewords.subspan(begin, end - begin);
                     const std::size_t at =
                         first_within(others, turns, levels[level].min_hamming - 1);
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
