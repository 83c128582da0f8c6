#pragma once

#include <string>
#include <string_view>

namespace tagmint::draw {

/// The characters of a UTF-8 text (RFC 3629). Throws std::invalid_argument when it is none.
std::u32string characters_of(std::string_view utf8);

/// A character as UTF-8.
std::string utf8_of(char32_t character);

}  // namespace tagmint::draw
