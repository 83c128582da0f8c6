#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "information_blocks.h"
#include "kernels/hamming_kernels.h"
#include "tagmint/codec/codeword.h"
#include "tagmint/codec/linear_map.h"

namespace tagmint::codec {

/// Finds all words of a code { shift ^ sum : shift one of the shifts, sum a sum of the basis } near
/// a given word, without a list of the code's words.
///
/// For each block of the plan the given word is replaced by its *rest*: what is left of it when the
/// sum that agrees with it in the block is taken away. That is one linear map, eight table
/// look-ups. Every sum that differs from the word in few bits of the block leaves the rest XOR one
/// of a list of words that is the same for all given words, so a scan of that list for words within
/// the radius of the rest finds them. The rests of the shifts are part of the list; so are the
/// sums that are 0 in the block, as far as the list stays short, and for the others the rest takes
/// one after the other in the order of a Gray code.
class InformationSetSearch {
 public:
  ///   basis    independent words of `bits` bits
  ///   shifts   at least one, each in another coset of the sums
  ///   radius   0 to bits
  ///   cost     of plan_search(), and some nanoseconds a listed word
  InformationSetSearch(std::span<const Codeword> basis, std::span<const Codeword> shifts, int bits,
                       int radius);

  /// Calls found(code word, its distance) for each word of the code within the radius, in a fixed
  /// order, some of them several times. What it returns is the radius from there on, at most the
  /// one so far; below 0 ends the search.
  ///   cost   words_compared() XORs and bit counts, some eight a nanosecond with AVX-512
  template <typename Found>
  void visit_near(Codeword word, const Found& found) const {
    int radius = radius_;
    for (const Block& block : blocks_) {
      Codeword rest = block.rest(word);
      for (std::uint64_t step = 1;; ++step) {
        const std::span<const Codeword> list = block.list;
        std::size_t at = first_within(list, rest, radius);
        while (at < list.size()) {
          const Codeword errors = rest ^ list[at];
          radius = found(word ^ errors, std::popcount(errors));
          if (radius < 0) return;
          ++at;
          at += first_within(list.subspan(at), rest, radius);
        }
        if (step >> block.kernel.size() != 0) break;
        rest ^= block.kernel[static_cast<std::size_t>(std::countr_zero(step))];
      }
    }
  }

  /// Words that one search compares with.
  std::uint64_t words_compared() const;
  /// Bytes of the tables.
  std::size_t table_bytes() const;

 private:
  struct Block {
    Block(const BlockSearch& search, std::span<const Codeword> shifts, int bits);

    LinearMap rest;
    std::vector<Codeword> list;    // a multiple of whole vectors long: the first word fills it up
    std::vector<Codeword> kernel;  // sums that are 0 in the block, of which no sum is listed
  };

  int bits_;
  int radius_;
  std::vector<Block> blocks_;
};

}  // namespace tagmint::codec
