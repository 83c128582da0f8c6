#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/sieve_plan.h"
#include "search/turn_index.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// Finds the words of long stretches of the walk that are far enough from many codes.
///
/// The step of the walk is odd, so words 2^t positions apart agree in their t low bits, and their
/// other bits form a progression of their own, with the same step:
///
///     v_(i + k 2^t)  =  [ upper_i + k step | low_i ]
///
/// So a stretch falls into 2^t groups without any sorting, and the words of one group have the same
/// near codes: those whose low bits differ little. A group is compared with these first, in order
/// of closeness, words in the lanes of vectors: codes whose t low bits differ in d leave
/// min_hamming - d for the others, which fit into lanes of 32 bits. The few words left over from
/// groups that agree in some lowest bits are pooled, compared with more codes in the same way, and
/// the very few then left with all.
///
/// Constant once made: threads may share one, each with a Scratch of its own.
class WalkSieve {
 public:
  /// Buffers of one thread, reused from call to call. They grow to 8 bytes for each word that the
  /// groups of one coarse group leave, 4 for each word of a group, and at worst 12 for each turn.
  struct Scratch {
    std::vector<std::uint32_t> uppers;
    std::vector<std::uint32_t> near_uppers;
    std::vector<Codeword> words;
    std::vector<Codeword> near_words;
  };

  /// A sieve for stretches of about `stretch` words of the walk over words of `bits` bits; above
  /// 2^32 they are taken piece by piece.
  ///   bits          1..64
  ///   min_hamming   1..bits
  ///   turns         all turns of all codes, as the walk visits them; fewer than 2^32
  ///   cost          less than a millisecond and O(turns + stretch / 16); memory: 12 bytes a turn
  ///                 and 4 for each of at most stretch / 16 cells, never more than 64 MiB
  WalkSieve(int bits, int min_hamming, std::span<const Codeword> turns, std::uint64_t stretch);
  /// The same, by a plan of the caller's: any plan gives the same result.
  WalkSieve(int bits, int min_hamming, std::span<const Codeword> turns, std::uint64_t stretch,
            const SievePlan& plan);

  /// Finds the words of first, first + step, ... (Walk::kStep, modulo 2^bits) that are at least
  /// min_hamming from every turn.
  ///   count     any number of words; beyond 2^bits they come again
  ///   returns   their indices in 0 .. count - 1, ascending
  std::vector<std::uint64_t> open_words(Codeword first, std::uint64_t count,
                                        Scratch& scratch) const;

  const SievePlan& plan() const { return plan_; }

  /// Whether making a sieve for a stretch and using it takes less time than keep_distant(). With
  /// fewer codes most words are open, and it costs more to collect them than to compare them; a
  /// shorter stretch costs less than the plan and the index (measured with 36 and 48 bits).
  static constexpr bool pays(std::size_t codes, std::uint64_t stretch) {
    return codes >= 100 && stretch >= std::uint64_t{1} << 16;
  }

 private:
  void sift_stretch(Codeword first, std::uint64_t count, Scratch& scratch,
                    std::vector<std::uint64_t>& open) const;
  std::size_t words_of_group(Codeword first, std::uint64_t count, Scratch& scratch,
                             std::size_t filled) const;
  std::size_t sift_group(Codeword first, std::uint64_t count, Scratch& scratch,
                         std::size_t filled) const;
  std::size_t sift_pool(std::uint32_t coarse_cell, Scratch& scratch, std::size_t count) const;

  int bits_;
  int min_hamming_;
  std::uint64_t stretch_;
  SievePlan plan_;
  TurnIndex index_;
  std::vector<std::vector<std::uint32_t>> fine_masks_;  // by weight
  std::vector<std::vector<std::uint32_t>> coarse_masks_;
};

}  // namespace tagmint::codec
