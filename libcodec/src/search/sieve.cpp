#include "search/sieve.h"

#include <algorithm>
#include <atomic>

#include "search/distance_filter.h"
#include "search/parallel.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// Words that a thread sifts at a time: 8 KiB of words, which stay in the first-level cache.
constexpr std::size_t kPortion = 1024;

SiftedWords joined(const std::vector<SiftedWords>& portions) {
  SiftedWords all;
  for (const SiftedWords& portion : portions) {
    all.kept.insert(all.kept.end(), portion.kept.begin(), portion.kept.end());
    all.distant += portion.distant;
  }
  return all;
}

}  // namespace

Sieve::Sieve(const SearchRules& rules, const Walk& walk, int threads)
    : bits_(rules.layout.bits()),
      min_hamming_(rules.min_hamming),
      judge_(rules.layout, rules.complexity),
      walk_(walk),
      workers_(threads) {}

void Sieve::learn(std::span<const Codeword> codes) {
  for (Codeword word : codes) {
    for (Codeword& turn : turns_.emplace_back()) {
      turn = walk_.to_visited(word);
      word = rotate_quarter(word, bits_);
    }
  }
}

SiftedWords Sieve::sift_portion(const WordSource& source, std::uint64_t first, std::size_t count,
                                TurnBlocks& blocks) {
  std::array<Codeword, kPortion> words;
  std::array<std::uint32_t, kPortion> distant;
  const std::span<Codeword> portion(words.data(), count);
  source(first, portion);
  const std::size_t distant_count = keep_distant(portion, blocks, min_hamming_, distant.data());
  SiftedWords sifted;
  for (std::size_t i = 0; i < distant_count; ++i) {
    const Codeword word = walk_.to_codeword(words[distant[i]]);
    if (self_distance(word, bits_) < min_hamming_) continue;
    ++sifted.distant;
    if (judge_.accepts(word)) sifted.kept.push_back({first + distant[i], word});
  }
  return sifted;
}

SiftedWords Sieve::sift(const WordSource& source, std::uint64_t first, std::uint64_t count) {
  const std::uint64_t portions = (count + kPortion - 1) / kPortion;
  std::vector<SiftedWords> sifted(portions);
  std::atomic<std::uint64_t> next_portion{0};
  const auto workers = static_cast<int>(std::min<std::uint64_t>(workers_.size(), portions));
  run_workers(workers, [&](int id) {
    Worker& worker = workers_[id];
    for (; worker.known < turns_.size(); ++worker.known) worker.blocks.add(turns_[worker.known]);
    for (std::uint64_t p; (p = next_portion++) < portions;) {
      const std::uint64_t begin = p * kPortion;
      const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(kPortion, count - begin));
      sifted[p] = sift_portion(source, first + begin, size, worker.blocks);
    }
  });
  return joined(sifted);
}

}  // namespace tagmint::codec
