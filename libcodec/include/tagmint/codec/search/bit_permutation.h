#pragma once

#include <array>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// A fixed rearrangement of the bits of a word. Hamming distances do not change under it.
class TAGMINT_API BitPermutation {
 public:
  /// Bit i of the input (0 = least significant) becomes bit `target[i]` of the output.
  /// Throws std::invalid_argument unless `target` holds 0 .. size-1 once each, size at most 64.
  explicit BitPermutation(std::span<const int> target);

  /// The rearranged word. Bits above size() of `word` must be zero.
  /// Cost: one look-up for every eight bits.
  Codeword operator()(Codeword word) const {
    Codeword moved = 0;
    for (const ByteTable& table : tables_) {
      moved |= table[word & 0xff];
      word >>= 8;
    }
    return moved;
  }

  /// Number of bits.
  int size() const { return static_cast<int>(target_.size()); }
  /// Where bit i goes, for each i.
  std::span<const int> target() const { return target_; }
  BitPermutation inverse() const;

 private:
  using ByteTable = std::array<Codeword, 256>;  // where the bits of one input byte go

  std::vector<int> target_;
  std::vector<ByteTable> tables_;
};

/// From codeword order to reading order: the data cells row by row from the top left of the printed
/// tag, the first the most significant bit. The classic families were searched in this order; old
/// tables give their codes in it.
TAGMINT_API BitPermutation reading_order(const Layout& layout);

}  // namespace tagmint::codec
