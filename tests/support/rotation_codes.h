#pragma once

#include "tagmint/codec/rotation_code.h"

/// Codes closed under quarter turns that tests share, each with the tags and distances of its
/// levels.
namespace tagmint::test {

/// 60 tags at distance 16, 2,016 at 12, 8,128 at 10, 130,816 at 8; with a translation.
codec::RotationCodeParts chain_of_36_bits();

/// 6 tags at distance 24, 120 at 20, 16,320 at 16, 4,193,280 at 12; with a translation.
codec::RotationCodeParts chain_of_48_bits();

/// 56 tags at distance 9, 120 at 8, 480 at 7; the centre bit is used.
codec::RotationCodeParts chain_of_25_bits();

/// 64 tags at distance 9: the first level of the chain of 25 bits, translated to a coset that has
/// no word a half turn maps to itself.
codec::RotationCodeParts coset_of_25_bits();

/// 3 tags at distance 8, 28 at 6, 60 at 5, 120 at 4.
codec::RotationCodeParts chain_of_16_bits();

/// 4 tags at distance 6, 16 at 5: the span of two words in 4 and in 16 cosets.
codec::RotationCodeParts cosets_of_16_bits();

}  // namespace tagmint::test
