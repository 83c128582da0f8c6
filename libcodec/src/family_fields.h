#pragma once

#include <optional>
#include <string_view>

#include "tagmint/codec/codeword.h"

/// The keys of a family file and what they hold.
namespace tagmint::codec {

/// What a key must hold. List elements have the list's path and "[]"; the file as a whole has the
/// empty path.
struct FamilyField {
  enum class Kind { Text, WholeNumber, Number, Code, List, Group };

  std::string_view path;
  Kind kind;
};

/// The field of that path; null where it is none of ours.
const FamilyField* find_family_field(std::string_view path);

/// What a value of the kind is, for messages: "a string".
std::string_view kind_name(FamilyField::Kind kind);

/// A codeword from "0x" and 16 hex digits; nothing for any other text.
std::optional<Codeword> parse_code(std::string_view text);

}  // namespace tagmint::codec
