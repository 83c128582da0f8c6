#include "cli/duration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/command.h"
#include "cli/number.h"

namespace tagmint::cli {
namespace {

struct Unit {
  std::string_view name;
  double seconds;
};

constexpr std::array<Unit, 5> kUnits = {
    {{"s", 1.0}, {"min", 60.0}, {"m", 60.0}, {"h", 3600.0}, {"d", 86400.0}}};

constexpr std::string_view kHint = "write numbers with s, min, h or d, like 90s or 1h30min";

}  // namespace

std::chrono::duration<double> parse_duration(std::string_view text, std::string_view option) {
  double seconds = 0.0;
  std::string_view rest = trimmed(text);
  do {
    const auto number = leading_number(rest);
    if (!number || number->value < 0) {
      throw UsageError(fmt::format("'{}' is not a time", text), option, kHint);
    }
    const std::size_t unit_end =
        std::min(number->rest.find_first_of("0123456789."), number->rest.size());
    const std::string_view name = trimmed(number->rest.substr(0, unit_end));
    if (name.empty()) {
      throw UsageError(fmt::format("the time '{}' has no unit", text), option, kHint);
    }
    const auto unit =
        std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == name; });
    if (unit == kUnits.end()) {
      throw UsageError(fmt::format("the time '{}' has the unknown unit '{}'", text, name), option,
                       kHint);
    }
    seconds += number->value * unit->seconds;
    rest = number->rest.substr(unit_end);
  } while (!rest.empty());
  if (seconds <= 0.0) throw UsageError("the time is zero", option, kHint);
  return std::chrono::duration<double>(seconds);
}

}  // namespace tagmint::cli
