#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "search/turn_blocks.h"
#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {

/// The greedy choice itself: words come in a given order, a word is taken when it is far enough
/// from its own turns and from all turns of all words taken before, and complex enough. Words come
/// in rounds. In a round all threads sift its words against the codes taken before the round; one
/// thread then goes through what is left, in order, and compares it with the codes of this round
/// alone. So the result depends neither on the number of threads nor on the size of the rounds.
class Greedy {
 public:
  /// Writes words first, first + 1, ... of the order, as the walk visits them, to `words`.
  using WordSource = std::function<void(std::uint64_t first, std::span<Codeword> words)>;

  /// What became of a round.
  struct Round {
    std::uint64_t judged = 0;     ///< words done; fewer than asked only where max_codes was reached
    std::size_t distant = 0;      ///< of these, far enough from the earlier codes and own turns
    std::size_t taken = 0;        ///< new codes
    std::size_t overlapping = 0;  ///< sifted in vain: too near to a code of the same round
  };

  /// `walk` must outlive the object; threads >= 1.
  Greedy(const Layout& layout, int min_hamming, const Complexity& complexity, const Walk& walk,
         int threads);

  /// Judges `count` words of `source`, starting with word `first`; stops behind the code that makes
  /// codewords() `max_codes` long.
  ///   cost   O(count * codes / threads) comparisons at worst; memory O(count / 100 + words kept)
  Round judge(const WordSource& source, std::uint64_t first, std::uint64_t count,
              std::size_t max_codes);

  /// Codes taken so far, in the order found, as codewords.
  const std::vector<Codeword>& codewords() const { return codewords_; }

  /// Forgets the codes for the filter, but keeps them in codewords(): for words that are known to
  /// be far enough from all codes taken up to now.
  void assume_distant_from_present_codes();

 private:
  using Turns = std::array<Codeword, 4>;
  struct Kept {
    std::uint64_t index;  // in the order
    Codeword word;        // as a codeword
  };
  struct Sifted {
    std::vector<Kept> kept;
    std::size_t distant = 0;
  };
  /// One thread's copy of the codes, in the order that suits it.
  struct Worker {
    TurnBlocks blocks;
    std::size_t known = 0;  // codes of turns_ that are in blocks
  };

  Sifted sift(const WordSource& source, std::uint64_t first, std::size_t count, TurnBlocks& blocks);
  void catch_up(Worker& worker) const;
  void take(Codeword word);

  int bits_;
  int min_hamming_;
  ComplexityJudge judge_;
  const Walk& walk_;
  std::vector<Codeword> codewords_;
  std::vector<Turns> turns_;  // of the codes that count for the filter, as the walk visits them
  std::vector<Worker> workers_;
};

}  // namespace tagmint::codec
