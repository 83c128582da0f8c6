#pragma once

#include <chrono>
#include <string_view>

namespace tagmint::cli {

/// A time from numbers and units: "30s", "5min", "1.5h", "2d", "1h30min". More than zero.
///   option   named in the message, for example "--time-limit"
/// Throws UsageError; a number without a unit is told so.
std::chrono::duration<double> parse_duration(std::string_view text, std::string_view option = {});

}  // namespace tagmint::cli
