#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// Some cells of a word, as one number: the bits of `mask` above the lowest `shift`.
struct CellMask {
  int shift = 0;
  Codeword mask = 0;

  Codeword of(Codeword word) const { return (word >> shift) & mask; }
};

/// Codewords, in one or in all four of their turns, by some of their cells:
///
///     place         the cells, or their hash where they are many; the highest bits are
///     bucket        begin and end in one list of entries
///     filter        three bits in one of some 64-bit words, set for the places that are there
///
/// Nearly all words whose cells are those of no codeword stop at the filter, which is some sixty
/// times smaller than a table of all words within two errors.
class CellIndex {
 public:
  /// A codeword's number in the list and how often it was turned: 4 * index + turns.
  using Entry = std::uint32_t;

  /// Where entries with some cells are to be looked for.
  using Place = std::uint64_t;

  /// `turns`: 1, the codewords as they stand, or 4. At most 2^30 codewords.
  CellIndex(std::span<const Codeword> codewords, int bits, int turns, const CellMask& cells);

  Place place(Codeword word) const {
    const Codeword key = cells_.of(word);
    // One multiplication mixes the high bits of the product, and only these are used.
    constexpr Codeword kMultiplier = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd
    return hashed_ ? key * kMultiplier : key << bucket_shift_;
  }

  /// 0 where no codeword has the cells of this place, else 1.
  unsigned may_hold(Place place) const {
    const Codeword word = filter_[place >> filter_shift_];
    return static_cast<unsigned>(word >> first_bit(place) & word >> second_bit(place) &
                                 word >> third_bit(place) & 1);
  }

  /// The entries with the cells of this place, and perhaps others.
  std::span<const Entry> entries(Place place) const {
    const std::size_t bucket = place >> bucket_shift_;
    return std::span(entries_).subspan(begins_[bucket], begins_[bucket + 1] - begins_[bucket]);
  }

  std::size_t bytes() const {
    return filter_.size() * sizeof(Codeword) + begins_.size() * sizeof(std::uint32_t) +
           entries_.size() * sizeof(Entry);
  }

 private:
  /// The three bits of a place, some of which may coincide.
  static int first_bit(Place place) { return static_cast<int>(place >> 40 & 63); }
  static int second_bit(Place place) { return static_cast<int>(place >> 34 & 63); }
  static int third_bit(Place place) { return static_cast<int>(place >> 28 & 63); }

  CellMask cells_;
  bool hashed_;
  int bucket_shift_ = 0;
  int filter_shift_ = 63;
  std::vector<Codeword> filter_;       // of places that are not hashed: two words of ones
  std::vector<std::uint32_t> begins_;  // of each bucket in entries_, and the end of the last
  std::vector<Entry> entries_;
};

}  // namespace tagmint::codec
