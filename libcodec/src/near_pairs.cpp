#include "tagmint/codec/near_pairs.h"

#include <algorithm>
#include <atomic>
#include <cassert>

#include "kernels/hamming_kernels.h"
#include "search/parallel.h"

namespace tagmint::codec {
namespace {

/// Rows (values of the first id) between two looks at whether there are pairs enough.
constexpr std::size_t kRowsAtATime = 256;

/// Adds the pairs of one row, no more than `most`.
void add_row(std::span<const Codeword> codewords, int bits, std::size_t row, int within,
             std::size_t most, std::vector<NearPair>& pairs) {
  const FourTurns turns = four_turns(codewords[row], bits);
  std::size_t found = 0;
  for (std::size_t at = row + 1; at < codewords.size() && found < most; ++at) {
    at += first_within(codewords.subspan(at), turns, within);
    if (at == codewords.size()) return;
    NearPair pair{static_cast<TagId>(row), static_cast<TagId>(at), kMaxBits + 1, 0};
    for (int turn = 0; turn < 4; ++turn) {
      const int distance = hamming_distance(turns[turn], codewords[at]);
      if (distance >= pair.distance) continue;
      // The first tag turned so often forward is the second one turned as often back.
      pair.distance = distance;
      pair.turns = (4 - turn) % 4;
    }
    pairs.push_back(pair);
    ++found;
  }
}

}  // namespace

std::vector<NearPair> near_pairs(const Family& family, int within, std::size_t most, int threads) {
  assert(family.is_listed());
  const std::span<const Codeword> codewords = family.codewords();
  const int workers = thread_count(threads);
  std::vector<NearPair> pairs;
  for (std::size_t begin = 0; begin < codewords.size() && pairs.size() < most;
       begin += kRowsAtATime) {
    const std::size_t end = std::min(begin + kRowsAtATime, codewords.size());
    std::vector<std::vector<NearPair>> rows(end - begin);
    std::atomic<std::size_t> next{begin};
    run_workers(workers, [&](int) {
      for (std::size_t row; (row = next.fetch_add(1)) < end;) {
        add_row(codewords, family.bits(), row, within, most, rows[row - begin]);
      }
    });
    for (const std::vector<NearPair>& row : rows) {
      const std::size_t wanted = std::min(row.size(), most - pairs.size());
      pairs.insert(pairs.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(wanted));
    }
  }
  return pairs;
}

}  // namespace tagmint::codec
