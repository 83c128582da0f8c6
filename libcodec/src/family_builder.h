#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "family_document.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

inline constexpr std::string_view kFamilyFormat = "tagmint-family";
inline constexpr std::uint64_t kFamilyVersion = 1;

/// The family that a document describes.
///   source   the document's name for messages
/// Throws InputError naming source, line and fault, as parse_family() says.
Family build_family(FamilyDocument document, const std::string& source);

}  // namespace tagmint::codec
