#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// The data bits of one tag: 1 = white cell, 0 = black cell. The first data cell of the layout's
/// walk is the most significant of the `bits` low bits; the bits above are zero.
using Codeword = std::uint64_t;

inline constexpr int kMaxBits = 64;

/// The `bits` low bits set; 0 <= bits <= 64.
constexpr Codeword low_mask(int bits) {
  return bits >= kMaxBits ? ~Codeword{0} : (Codeword{1} << bits) - 1;
}

/// Number of bits in which two words differ.
constexpr int hamming_distance(Codeword a, Codeword b) { return std::popcount(a ^ b); }

/// "0x" and 16 lowercase hex digits, as family files write codewords.
TAGMINT_API std::string to_hex(Codeword word);

}  // namespace tagmint::codec
