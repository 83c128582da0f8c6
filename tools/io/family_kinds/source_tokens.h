#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "io/family_kinds/family_source.h"

namespace tagmint::io {

/// A piece of a program's source.
struct SourceToken {
  enum class Kind {
    Word,    ///< a name
    Number,  ///< as written: 0x1fULL
    Text,    ///< what stands between double quotes, as written
    Sign,    ///< one character of punctuation
  };
  Kind kind = Kind::Sign;
  std::string_view text;
  int line = 0;

  bool is(std::string_view word) const { return kind != Kind::Text && text == word; }
};

/// The tokens of C, C++ or Java source; comments and lines of the preprocessor are passed over.
/// Throws codec::InputError for a comment or a text without an end.
///   returns   views into source.content
std::vector<SourceToken> source_tokens(const FamilySource& source);

/// The value of a whole number: decimal, hexadecimal, octal or binary, with or without suffix and
/// digit separators. Throws codec::InputError when it is none or has more than 64 bits.
std::uint64_t token_number(const SourceToken& token, const FamilySource& source);

}  // namespace tagmint::io
