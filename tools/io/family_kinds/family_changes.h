#pragma once

#include <string>

#include "io/family_kinds/family_kind.h"
#include "tagmint/codec/family.h"

namespace tagmint::io {

/// The same family under another name. Throws std::invalid_argument for a name that cannot be.
codec::Family renamed(const codec::Family& family, const std::string& name);

/// A family that says all of itself, with what the options may still change: its name.
/// Throws std::invalid_argument for options that contradict it.
codec::Family with_options(codec::Family family, const FamilyReadOptions& options);

}  // namespace tagmint::io
