#include "tagmint/codec/search/completeness.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "search/engines.h"
#include "search/parallel.h"
#include "search/round_pacer.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using Clock = std::chrono::steady_clock;

SearchRules rules_for(const Family& family) {
  return {family.layout(), family.min_hamming(), Order{}, family.complexity()};
}

/// One proof; its two ways to go through the space.
class Proof {
 public:
  Proof(const Family& family, const CompletenessOptions& options)
      : options_(options),
        bits_(family.bits()),
        judge_(family.layout(), family.complexity()),
        threads_(thread_count(options.threads)),
        crew_(options.crew ? options.crew(rules_for(family), options.threads)
                           : local_crew(rules_for(family), options.threads)) {
    crew_->learn(first_codewords(family, family.size()));
  }

  Completeness by_tree();
  Completeness by_walk();

 private:
  /// The least turn of these tags that is complex enough.
  std::optional<Codeword> least_complex(std::span<const Codeword> tags) const;
  std::optional<Codeword> first_complex(std::span<const Codeword> words) const;
  std::optional<Codeword> addable_in(std::uint64_t first, std::uint64_t count) const {
    return least_complex(crew_->list_open(first, count));
  }
  Codeword addable_of_first_subtree(std::uint64_t first, std::uint64_t count, Codeword known) const;
  void report(double words) const {
    if (options_.progress) options_.progress(words, std::ldexp(1.0, bits_));
  }

  const CompletenessOptions& options_;
  int bits_;
  ComplexityJudge judge_;
  int threads_;
  std::unique_ptr<SearchCrew> crew_;
};

/// The first complex one of a few words, judged by all threads.
std::optional<Codeword> Proof::first_complex(std::span<const Codeword> words) const {
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> found{words.size()};
  run_workers(std::min<int>(threads_, static_cast<int>(words.size())), [&](int) {
    for (std::size_t i; (i = next++) < found;) {
      if (!judge_.accepts(words[i])) continue;
      for (std::size_t before = found; i < before && !found.compare_exchange_weak(before, i);) {
      }
    }
  });
  if (found == words.size()) return std::nullopt;
  return words[found];
}

std::optional<Codeword> Proof::least_complex(std::span<const Codeword> tags) const {
  constexpr std::size_t kWordsAtATime = 1 << 12;  // a few threads' work of some milliseconds
  std::vector<Codeword> words;
  words.reserve(4 * tags.size());
  for (const Codeword tag : tags) {
    for (int turn = 0; turn < 4; ++turn) words.push_back(rotate(tag, bits_, turn));
  }
  std::sort(words.begin(), words.end());
  for (std::size_t i = 0; i < words.size(); i += kWordsAtATime) {
    const std::size_t count = std::min(kWordsAtATime, words.size() - i);
    if (const auto word = first_complex(std::span(words).subspan(i, count))) return word;
  }
  return std::nullopt;
}

/// Halves a round that holds an addable word, `known`, down to the first subtree that does.
Codeword Proof::addable_of_first_subtree(std::uint64_t first, std::uint64_t count,
                                         Codeword known) const {
  while (count > 1) {
    const std::uint64_t half = count / 2;
    if (const auto word = addable_in(first, half)) {
      known = *word;
      count = half;
    } else {
      first += half;
      count -= half;
      if (count == 1) known = *addable_in(first, count);
    }
  }
  return known;
}

Completeness Proof::by_tree() {
  constexpr std::uint64_t kWorthwhileSubtrees = 16;
  constexpr std::uint64_t kMostSubtrees = std::uint64_t{1} << 22;
  const std::uint64_t subtrees = subtree_count(bits_);
  RoundPacer pacer(1, kWorthwhileSubtrees, kMostSubtrees);
  for (std::uint64_t first = 0; first < subtrees;) {
    if (options_.stop.stop_requested()) return {.stopped = true, .addable = std::nullopt};
    const std::uint64_t count = std::min(pacer.pieces(), subtrees - first);
    const auto before = Clock::now();
    if (const auto word = addable_in(first, count)) {
      return {.stopped = false, .addable = addable_of_first_subtree(first, count, *word)};
    }
    pacer.learn(Clock::now() - before, crew_->round_length());
    first += count;
    report(std::ldexp(static_cast<double>(first) / static_cast<double>(subtrees), bits_));
  }
  return {};
}

Completeness Proof::by_walk() {
  constexpr std::uint64_t kFewestWords = 1 << 12;
  constexpr std::uint64_t kWorthwhileWords = std::uint64_t{1} << 22;
  constexpr std::uint64_t kMostWords = std::uint64_t{1} << 26;
  const std::uint64_t last = low_mask(bits_);
  RoundPacer pacer(kFewestWords, kWorthwhileWords, kMostWords);
  for (std::uint64_t first = 0;;) {
    if (options_.stop.stop_requested()) return {.stopped = true, .addable = std::nullopt};
    const std::uint64_t beyond_first = last - first;  // left but one: 2^64 do not fit
    const std::uint64_t count = std::min(pacer.pieces() - 1, beyond_first) + 1;
    const auto before = Clock::now();
    const SiftedWords sifted = crew_->sift(first, count);
    if (!sifted.kept.empty()) return {.stopped = false, .addable = sifted.kept.front().word};
    pacer.learn(Clock::now() - before, crew_->round_length());
    report(static_cast<double>(first) + static_cast<double>(count));
    if (count - 1 == beyond_first) return {};
    first += count;
  }
}

}  // namespace

Completeness prove_complete(const Family& family, const CompletenessOptions& options) {
  Proof proof(family, options);
  return tree_search_possible(family.bits()) ? proof.by_tree() : proof.by_walk();
}

}  // namespace tagmint::codec
