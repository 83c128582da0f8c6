#include "draw/numbers.h"

#include <array>
#include <charconv>

namespace tagmint::draw {

void append_number(std::string& out, double value, int digits) {
  std::array<char, 340> text;  // the longest double has 309 digits before its point
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits)
          .ptr;
  std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
  if (digits > 0) {
    number = number.substr(0, number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.remove_suffix(1);
  }
  if (number == "-0") number.remove_prefix(1);
  out += number;
}

std::string number_text(double value, int digits) {
  std::string text;
  append_number(text, value, digits);
  return text;
}

}  // namespace tagmint::draw
