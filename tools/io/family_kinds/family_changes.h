#pragma once

#include <cstddef>
#include <string>

#include "io/family_kinds/family_kind.h"
#include "tagmint/codec/family.h"

namespace tagmint::io {

/// The same family under another name. Throws std::invalid_argument for a name that cannot be.
codec::Family renamed(const codec::Family& family, const std::string& name);

/// A family that says all of itself, with what the options may still change: its name.
/// Throws std::invalid_argument for options that contradict it.
codec::Family with_options(codec::Family family, const FamilyReadOptions& options);

/// The first `codes` tags as a family of listed codewords, at the distance of the smallest level
/// that holds them.
///   codes   1 to family.size()
codec::Family first_tags(const codec::Family& family, std::size_t codes);

}  // namespace tagmint::io
