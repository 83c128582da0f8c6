#include "search/greedy.h"

#include <algorithm>
#include <atomic>

#include "search/distance_filter.h"
#include "search/parallel.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// Words that a thread sifts at a time: 8 KiB of words, which stay in the first-level cache.
constexpr std::size_t kPortion = 1024;

}  // namespace

Greedy::Greedy(const Layout& layout, int min_hamming, const Complexity& complexity,
               const Walk& walk, int threads)
    : bits_(layout.bits()),
      min_hamming_(min_hamming),
      judge_(layout, complexity),
      walk_(walk),
      workers_(threads) {}

Greedy::Sifted Greedy::sift(const WordSource& source, std::uint64_t first, std::size_t count,
                            TurnBlocks& blocks) {
  std::array<Codeword, kPortion> words;
  std::array<std::uint32_t, kPortion> distant;
  const std::span<Codeword> portion(words.data(), count);
  source(first, portion);
  const std::size_t distant_count = keep_distant(portion, blocks, min_hamming_, distant.data());
  Sifted sifted;
  for (std::size_t i = 0; i < distant_count; ++i) {
    const Codeword word = walk_.to_codeword(words[distant[i]]);
    if (self_distance(word, bits_) < min_hamming_) continue;
    ++sifted.distant;
    if (judge_.accepts(word)) sifted.kept.push_back({first + distant[i], word});
  }
  return sifted;
}

void Greedy::catch_up(Worker& worker) const {
  for (; worker.known < turns_.size(); ++worker.known) worker.blocks.add(turns_[worker.known]);
}

void Greedy::take(Codeword word) {
  codewords_.push_back(word);
  Turns& turns = turns_.emplace_back();
  for (Codeword& turn : turns) {
    turn = walk_.to_visited(word);
    word = rotate_quarter(word, bits_);
  }
}

Greedy::Round Greedy::judge(const WordSource& source, std::uint64_t first, std::uint64_t count,
                            std::size_t max_codes) {
  if (codewords_.size() >= max_codes) return {};
  const std::uint64_t portions = (count + kPortion - 1) / kPortion;
  std::vector<Sifted> sifted(portions);
  std::atomic<std::uint64_t> next_portion{0};
  const auto workers = static_cast<int>(std::min<std::uint64_t>(workers_.size(), portions));
  run_workers(workers, [&](int id) {
    Worker& worker = workers_[id];
    catch_up(worker);
    for (std::uint64_t p; (p = next_portion++) < portions;) {
      const std::uint64_t begin = p * kPortion;
      const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(kPortion, count - begin));
      sifted[p] = sift(source, first + begin, size, worker.blocks);
    }
  });

  Round round{.judged = count};
  const std::size_t codes_before = codewords_.size();
  for (const Sifted& portion : sifted) {
    round.distant += portion.distant;
    for (const auto& [index, word] : portion.kept) {
      const bool overlaps =
          std::any_of(codewords_.begin() + static_cast<std::ptrdiff_t>(codes_before),
                      codewords_.end(), [&, word = word](Codeword code) {
                        return rotation_distance(word, code, bits_) < min_hamming_;
                      });
      if (overlaps) {
        ++round.overlapping;
        continue;
      }
      take(word);
      ++round.taken;
      if (codewords_.size() == max_codes) {
        round.judged = index - first + 1;
        return round;
      }
    }
  }
  return round;
}

void Greedy::assume_distant_from_present_codes() {
  turns_.clear();
  for (Worker& worker : workers_) worker = Worker{};
}

}  // namespace tagmint::codec
