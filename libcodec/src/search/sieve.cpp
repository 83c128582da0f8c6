#include "search/sieve.h"

#include <algorithm>
#include <array>
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
    for (int turn = 0; turn < 4; ++turn) {
      turns_.push_back(walk_.to_visited(word));
      word = rotate_quarter(word, bits_);
    }
  }
}

/// The codes as one thread has them, brought up to date.
TurnBlocks& Sieve::blocks_of(int worker) {
  auto& [blocks, known, scratch] = workers_[worker];
  for (; known < turns_.size(); known += 4) {
    blocks.add(std::span(turns_).subspan(known).first<4>());
  }
  return blocks;
}

/// Keeps a word that is far enough from all codes, where it passes the other tests.
void Sieve::judge(std::uint64_t index, Codeword visited, SiftedWords& sifted) const {
  const Codeword word = walk_.to_codeword(visited);
  if (self_distance(word, bits_) < min_hamming_) return;
  ++sifted.distant;
  if (judge_.accepts(word)) sifted.kept.push_back({index, word});
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
    judge(first + distant[i], words[distant[i]], sifted);
  }
  return sifted;
}

SiftedWords Sieve::sift(const WordSource& source, std::uint64_t first, std::uint64_t count) {
  const std::uint64_t portions = (count + kPortion - 1) / kPortion;
  std::vector<SiftedWords> sifted(portions);
  std::atomic<std::uint64_t> next_portion{0};
  const auto workers = static_cast<int>(std::min<std::uint64_t>(workers_.size(), portions));
  run_workers(workers, [&](int id) {
    TurnBlocks& blocks = blocks_of(id);
    for (std::uint64_t p; (p = next_portion++) < portions;) {
      const std::uint64_t begin = p * kPortion;
      const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(kPortion, count - begin));
      sifted[p] = sift_portion(source, first + begin, size, blocks);
    }
  });
  return joined(sifted);
}

void Sieve::erase_near(std::vector<Codeword>& codewords, const std::function<bool()>& must_end) {
  if (turns_.empty()) return;
  // A word that may stay moves to the beginning of its own portion; the portions close up at last.
  const std::size_t portions = (codewords.size() + kPortion - 1) / kPortion;
  std::vector<std::size_t> left(portions);
  std::atomic<std::size_t> next_portion{0};
  run_workers(static_cast<int>(workers_.size()), [&](int id) {
    TurnBlocks& blocks = blocks_of(id);
    std::array<Codeword, kPortion> visited;
    std::array<std::uint32_t, kPortion> distant;
    for (std::size_t p; (p = next_portion++) < portions;) {
      Codeword* const begin = codewords.data() + p * kPortion;
      const std::size_t size = std::min(kPortion, codewords.size() - p * kPortion);
      left[p] = size;
      if (must_end()) continue;
      std::transform(begin, begin + size, visited.begin(),
                     [this](Codeword word) { return walk_.to_visited(word); });
      left[p] = keep_distant({visited.data(), size}, blocks, min_hamming_, distant.data());
      for (std::size_t i = 0; i < left[p]; ++i) begin[i] = begin[distant[i]];
    }
  });
  auto end = codewords.begin();
  for (std::size_t p = 0; p < portions; ++p) {
    const auto begin = codewords.begin() + static_cast<std::ptrdiff_t>(p * kPortion);
    end = std::copy(begin, begin + static_cast<std::ptrdiff_t>(left[p]), end);
  }
  codewords.erase(end, codewords.end());
}

SiftedWords Sieve::sift_walk(std::uint64_t first, std::uint64_t count) {
  return WalkSieve::pays(turns_.size() / 4, count / workers_.size()) ? sift_by_groups(first, count)
                                                                     : sift_each(first, count);
}

SiftedWords Sieve::sift_each(std::uint64_t first, std::uint64_t count) {
  return sift(
      [this](std::uint64_t begin, std::span<Codeword> words) {
        Codeword word = walk_.visited(begin + 1);
        for (Codeword& slot : words) {
          slot = word;
          word = (word + Walk::kStep) & low_mask(bits_);
        }
      },
      first, count);
}

SiftedWords Sieve::sift_by_groups(std::uint64_t first, std::uint64_t count) {
  // Long portions, as the words of a portion fall into groups, and large groups cost less.
  const std::uint64_t portion = (count - 1) / workers_.size() + 1;
  const WalkSieve sieve(bits_, min_hamming_, turns_, portion);
  std::vector<SiftedWords> sifted(workers_.size());
  run_workers(static_cast<int>(workers_.size()), [&](int id) {
    const std::uint64_t begin = std::min(count, id * portion);
    const std::uint64_t size = std::min(portion, count - begin);
    const Codeword start = walk_.visited(first + begin + 1);
    for (const std::uint64_t i : sieve.open_words(start, size, workers_[id].scratch)) {
      judge(first + begin + i, walk_.visited(first + begin + i + 1), sifted[id]);
    }
  });
  return joined(sifted);
}

}  // namespace tagmint::codec
