#include "cli/number.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "cli/command.h"

namespace tagmint::cli {

std::optional<LeadingNumber> leading_number(std::string_view text) {
  double value = 0.0;
  const char* end_of_text = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), end_of_text, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return LeadingNumber{value, text.substr(static_cast<std::size_t>(end - text.data()))};
}

std::uint64_t parse_count(std::string_view text, std::string_view option) {
  std::uint64_t count = 0;
  const char* end_of_text = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), end_of_text, count);
  if (error == std::errc() && end == end_of_text && count > 0) return count;
  // Powers of ten are exact as doubles up to 2^53.
  constexpr double kLargestExact = 9007199254740992.0;
  const auto number = leading_number(text);
  const bool whole = number && number->rest.empty() && number->value >= 1.0 &&
                     number->value <= kLargestExact && number->value == std::floor(number->value);
  if (!whole) {
    throw UsageError(fmt::format("'{}' is not a count", text), option,
                     "write a whole number of at least 1, like 5000 or 1e9");
  }
  return static_cast<std::uint64_t>(number->value);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace tagmint::cli
