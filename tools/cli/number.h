#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tagmint::cli {

/// The decimal number at the start of `text`, and what follows it.
struct LeadingNumber {
  double value = 0.0;
  std::string_view rest;
};

/// Splits "1.5in" into 1.5 and "in". Nothing when `text` does not start with a finite decimal
/// number. Does not depend on the locale.
std::optional<LeadingNumber> leading_number(std::string_view text);

/// A whole number of at least 1: "587", also as a power of ten, "1e9". Throws UsageError naming the
/// option.
std::uint64_t parse_count(std::string_view text, std::string_view option);

/// `text` without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace tagmint::cli
