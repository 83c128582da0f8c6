#pragma once

#include <string>

namespace tagmint::draw {

inline constexpr double kMmAnInch = 25.4;
inline constexpr double kPointsAnInch = 72.0;
inline constexpr double kPointsAMm = kPointsAnInch / kMmAnInch;

/// A length for people, rounded to a micrometre: "40 mm", "12.5 mm".
///   separator   between number and unit; "" gives the form that options take
std::string format_mm(double length_mm, const char* separator = " ");

}  // namespace tagmint::draw
