#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "search/turn_blocks.h"
#include "search/walk_sieve.h"
#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/search/crew.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {

/// Sifts words against the codes that it has learnt, with several threads: what is left is far
/// enough from all turns of these codes and from its own, and complex enough.
class Sieve {
 public:
  /// Writes words first, first + 1, ... of some order, as the walk visits them, to `words`.
  using WordSource = std::function<void(std::uint64_t first, std::span<Codeword> words)>;

  /// `walk` must outlive the object; threads >= 1.
  Sieve(const SearchRules& rules, const Walk& walk, int threads);

  void learn(std::span<const Codeword> codes);

  /// The words `first` .. `first + count - 1` of `source`. The index of a word that is kept is its
  /// place in that order.
  ///   cost   O(count * codes / threads) comparisons at worst; memory O(count / 100 + words kept)
  SiftedWords sift(const WordSource& source, std::uint64_t first, std::uint64_t count);

  /// Removes the codewords that are too near to a code, whatever their own turns and complexity.
  /// Once `must_end` says so, the rest of them stay as they are; it is asked from all threads.
  void erase_near(std::vector<Codeword>& codewords, const std::function<bool()>& must_end);

  /// The same as sift() for the words `first` .. `first + count - 1` of the walk, one by one.
  SiftedWords sift_each(std::uint64_t first, std::uint64_t count);

  /// The same, with WalkSieve where there are so many codes and words that this is faster.
  SiftedWords sift_walk(std::uint64_t first, std::uint64_t count);

 private:
  /// One thread's copy of the codes, in the order that suits it.
  struct Worker {
    TurnBlocks blocks;
    std::size_t known = 0;  // turns that are in blocks
    WalkSieve::Scratch scratch;
  };

  SiftedWords sift_portion(const WordSource& source, std::uint64_t first, std::size_t count,
                           TurnBlocks& blocks);
  SiftedWords sift_by_groups(std::uint64_t first, std::uint64_t count);
  TurnBlocks& blocks_of(int worker);
  void judge(std::uint64_t index, Codeword visited, SiftedWords& sifted) const;

  int bits_;
  int min_hamming_;
  ComplexityJudge judge_;
  const Walk& walk_;
  std::vector<Codeword> turns_;  // four of each code, as the walk visits them
  std::vector<Worker> workers_;
};

}  // namespace tagmint::codec
