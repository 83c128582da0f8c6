#pragma once

#include <string>
#include <vector>

#include "search/rotation/random_choice.h"
#include "search/rotation/turn_code.h"

namespace tagmint::codec {

/// A code of the literature whose places are in such an order that a quarter turn maps it to
/// itself.
struct KnownCode {
  TurnCode code;
  int distance = 0;  ///< its minimum distance is at least so much
};

/// Codes of one length, each inside the next.
struct KnownChain {
  std::string name;  ///< "extended quadratic residue code of 47"
  int bits = 0;      ///< divisible by 4
  std::vector<KnownCode> codes;
};

/// The extended quadratic residue codes of length 8, 24 (Golay's), 32 and 48, and the extended BCH
/// codes of length 16 and 64 (Reed-Muller's of first order among them). docs/rotation-codes.md
/// tells why they are closed.
std::vector<KnownChain> known_chains();

/// The chain in `bits` bits: shortened to random cycles of four places where it is longer, with
/// cells that are 0 where it is shorter; the centre bit, if there is one, is 0. Codes of dimension
/// 0 or above 30 are left out.
KnownChain fit_chain(const KnownChain& chain, int bits, RandomChoice& random);

}  // namespace tagmint::codec
