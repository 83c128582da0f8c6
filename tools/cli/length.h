#pragma once

#include <string_view>

namespace tagmint::cli {

/// A length in millimetres from a number and a unit: "40mm", "4cm", "0.04m", "1.5in", "12pt" (1 pt
/// = 1/72 in). Zero is a length, a negative one is not.
///   option   named in the message, for example "--edge"
/// Throws UsageError; a number without a unit is told so.
double parse_length_mm(std::string_view text, std::string_view option = {});

}  // namespace tagmint::cli
