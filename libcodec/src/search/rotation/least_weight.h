#pragma once

#include <span>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// The least weight of a sum of some of `basis`, independent words, other than 0: the minimum
/// distance of the linear code that they span. kMaxBits + 1 for an empty basis.
/// Cost: O(2^basis) words, some three a nanosecond.
int least_weight(std::span<const Codeword> basis);

}  // namespace tagmint::codec
