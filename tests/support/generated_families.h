#pragma once

#include "tagmint/codec/family.h"

/// Families whose codewords are generated, with what they declare proven elsewhere.
namespace tagmint::test {

/// 130,816 tags on classic:10 in four levels: 60 at distance 16, 2,016 at 12, 8,128 at 10, all
/// at 8. Rule energy:0.3333; 9,716 tags are plain.
codec::FamilyParts generated_36();

/// 64 tags on classic:9 at distance 9, no rule.
codec::FamilyParts generated_25();

/// 16 tags on classic:8 at distance 5, the first 4 of them at 6, by cosets; no rule.
codec::FamilyParts generated_16();

/// The same family with its codewords listed.
codec::Family listed(const codec::Family& family);

}  // namespace tagmint::test
