#pragma once

#include <algorithm>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// The word that a quarter turn makes of `word`. A word is four equal blocks a b c d, one for each
/// quarter of the tag, and a centre bit z where bits % 4 == 1 (docs/layouts.md):
///
///     most significant  [ a | b | c | d | z ]  least     ->     [ b | c | d | a | z ]
///
///   bits     number of data bits, 1..64, bits % 4 is 0 or 1
///   returns  what a camera reads when the tag has been turned by 90 degrees counter-clockwise as
///   seen
constexpr Codeword rotate_quarter(Codeword word, int bits) {
  const int centre_bits = bits % 4;
  const int ring_bits = bits - centre_bits;
  if (ring_bits == 0) return word;
  const int block = ring_bits / 4;
  const Codeword centre = word & low_mask(centre_bits);
  const Codeword ring = word >> centre_bits;
  const Codeword turned = ((ring << block) | (ring >> (ring_bits - block))) & low_mask(ring_bits);
  return (turned << centre_bits) | centre;
}

/// `turns` quarter turns; any integer, taken modulo 4.
constexpr Codeword rotate(Codeword word, int bits, int turns) {
  for (int i = 0; i < (turns & 3); ++i) word = rotate_quarter(word, bits);
  return word;
}

/// Smallest Hamming distance between `a` and the four turns of `b`.
constexpr int rotation_distance(Codeword a, Codeword b, int bits) {
  int least = kMaxBits + 1;
  for (int turn = 0; turn < 4; ++turn, b = rotate_quarter(b, bits)) {
    least = std::min(least, hamming_distance(a, b));
  }
  return least;
}

/// Smallest Hamming distance between two different turns of one word. A quarter turn and three of
/// them give the same distance, so two comparisons decide.
constexpr int self_distance(Codeword word, int bits) {
  const Codeword quarter = rotate_quarter(word, bits);
  const Codeword half = rotate_quarter(quarter, bits);
  return std::min(hamming_distance(word, quarter), hamming_distance(word, half));
}

}  // namespace tagmint::codec
