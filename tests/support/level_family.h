#pragma once

#include <span>
#include <string_view>

#include "tagmint/codec/family.h"
#include "tagmint/codec/rotation_code.h"

namespace tagmint::test {

/// The tags of a rotation code as a family that lists them: its levels in order, in each the orbits
/// of four different words by their smallest address. No complexity rule.
///   layout_name   a layout with the code's number of bits
///   distances     declared of the levels, the first level's first; a level is not listed that has
///                 none
codec::SharedFamily listed_family(const codec::RotationCodeParts& parts,
                                  std::string_view layout_name, std::span<const int> distances);

}  // namespace tagmint::test
