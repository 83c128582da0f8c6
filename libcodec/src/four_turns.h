#pragma once

#include <array>

#include "tagmint/codec/rotation.h"

namespace tagmint::codec {

/// The four turns of one word, rotate(word, bits, 0..3).
using FourTurns = std::array<Codeword, 4>;

/// Each made by itself rather than from the one before, so that a processor makes them side by
/// side: a look-up would spend much of its time on a chain of turns.
inline FourTurns four_turns(Codeword word, int bits) {
  const int centre_bits = bits % 4;
  const int block = bits / 4;
  if (block == 0) return {word, word, word, word};
  const Codeword centre = word & low_mask(centre_bits);
  const Codeword ring = word >> centre_bits;
  const Codeword mask = low_mask(4 * block);
  FourTurns turns{};
  turns[0] = word;
  for (int turn = 1; turn < 4; ++turn) {
    const Codeword moved = (ring << turn * block | ring >> (4 - turn) * block) & mask;
    turns[static_cast<std::size_t>(turn)] = moved << centre_bits | centre;
  }
  return turns;
}

}  // namespace tagmint::codec
