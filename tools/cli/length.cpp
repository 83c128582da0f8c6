#include "cli/length.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/command.h"
#include "cli/number.h"

namespace tagmint::cli {
namespace {

struct Unit {
  std::string_view name;
  double mm;
};

constexpr std::array<Unit, 5> kUnits = {
    {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}, {"pt", 25.4 / 72.0}}};

/// Beyond all paper, rooms and views of a camera: a mistyped exponent.
constexpr double kMaxLength_mm = 1e6;

constexpr std::string_view kUnitList = "mm, cm, m, in, pt";

}  // namespace

double parse_length_mm(std::string_view text, std::string_view option) {
  const auto number = leading_number(trimmed(text));
  if (!number) {
    throw UsageError(fmt::format("'{}' is not a length", text), option,
                     fmt::format("write a number and a unit ({}), like 40mm", kUnitList));
  }
  if (number->value < 0) {
    throw UsageError(fmt::format("the length '{}' is negative", text), option,
                     "write a length of zero or more, like 40mm");
  }
  const std::string_view name = trimmed(number->rest);
  if (name.empty()) {
    throw UsageError(fmt::format("the length '{}' has no unit", text), option,
                     fmt::format("add one of {}, like {}mm", kUnitList, trimmed(text)));
  }
  const auto unit =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == name; });
  if (unit == kUnits.end()) {
    throw UsageError(fmt::format("the length '{}' has the unknown unit '{}'", text, name), option,
                     fmt::format("use one of {}", kUnitList));
  }
  const double mm = number->value * unit->mm;
  if (mm > kMaxLength_mm) {
    throw UsageError(fmt::format("the length '{}' is above 1000 m", text), option,
                     "write a shorter one, like 40mm");
  }
  return mm;
}

}  // namespace tagmint::cli
