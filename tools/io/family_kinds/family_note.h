#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/family_kinds/family_kind.h"
#include "tagmint/codec/family.h"

namespace tagmint::io {

/// All that a family file says of a family but its codewords, as one line of JSON in ASCII: kinds
/// with room for a comment carry it, so that tagmint gets everything back.
std::string family_note(const codec::Family& family);

/// The family of a note and the codewords that the file lists. Nothing when the note is damaged or
/// belongs to other codewords: its digest tells.
std::optional<codec::Family> family_of_note(std::string_view note,
                                            std::span<const codec::Codeword> codewords);

}  // namespace tagmint::io
