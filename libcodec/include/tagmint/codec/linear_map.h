#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// A linear map over GF(2): words of at most 64 bits to words of at most 64 bits. One table of 256
/// entries a byte of the argument, so that a product costs one look-up and one XOR a byte.
class TAGMINT_API LinearMap {
 public:
  /// The map that takes every word to 0.
  LinearMap() = default;

  /// The map that takes bit i, counted from the least significant, to columns[i]; at most 64
  /// columns.
  explicit LinearMap(std::span<const Codeword> columns) : tables_((columns.size() + 7) / 8) {
    for (std::size_t byte = 0; byte < tables_.size(); ++byte) {
      const auto own = columns.subspan(8 * byte);
      std::array<Codeword, 256>& table = tables_[byte];
      table[0] = 0;
      // Each entry is that of its bits below the highest, and the highest bit's column.
      for (std::size_t bit = 0; bit < 8; ++bit) {
        const Codeword column = bit < own.size() ? own[bit] : 0;
        const std::size_t half = std::size_t{1} << bit;
        for (std::size_t low = 0; low < half; ++low) table[half + low] = table[low] ^ column;
      }
    }
  }

  /// XOR of the columns whose bits are set in `argument`; bits without a column count nothing.
  Codeword operator()(Codeword argument) const {
    Codeword sum = 0;
    for (const std::array<Codeword, 256>& table : tables_) {
      sum ^= table[argument & 0xff];
      argument >>= 8;
    }
    return sum;
  }

 private:
  std::vector<std::array<Codeword, 256>> tables_;
};

}  // namespace tagmint::codec
