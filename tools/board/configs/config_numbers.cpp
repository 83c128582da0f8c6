#include "board/configs/config_numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tagmint::board {

std::string decimal(double value) {
  std::string text = fmt::format("{:.12f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text += '0';
  return text == "-0.0" ? "0.0" : text;
}

std::string metres(double length_mm) { return decimal(length_mm / 1000.0); }

HalfTurn half_turn(double clockwise_deg) {
  const double angle = std::remainder(-clockwise_deg, 360.0);  // -180 .. 180: the cosine is >= 0
  const double half = angle / 2 * std::numbers::pi / 180.0;
  return {std::cos(half), std::sin(half)};
}

}  // namespace tagmint::board
