#include "plot/style.h"

#include <array>
#include <stdexcept>
#include <string>

namespace tagmint::plot {
namespace {

constexpr std::array<double, 2> kLong = {8, 3};
constexpr std::array<double, 2> kShort = {3, 2.5};
constexpr std::array<double, 4> kDashDot = {8, 2.5, 2, 2.5};
constexpr std::array<double, 2> kDots = {1.5, 2};
constexpr std::array<double, 6> kDashDotDot = {7, 2, 1.5, 2, 1.5, 2};
constexpr std::array<double, 2> kWide = {12, 4};

// From dark to light, and each beside a neighbour of other hue.
const std::array<Style, kStyles> kTable = {{
    {{0.05, 0.15, 0.42}, {}, Marker::Disc, 2.0},
    {{0.62, 0.10, 0.10}, kLong, Marker::Square, 1.6},
    {{0.12, 0.45, 0.25}, kShort, Marker::Triangle, 1.6},
    {{0.78, 0.42, 0.05}, kDashDot, Marker::Diamond, 1.6},
    {{0.42, 0.25, 0.60}, kDots, Marker::Cross, 1.8},
    {{0.15, 0.50, 0.70}, kDashDotDot, Marker::Down, 1.6},
    {{0.45, 0.45, 0.45}, kWide, Marker::Plus, 1.6},
    {{0.00, 0.00, 0.00}, kDots, Marker::Ring, 1.2},
}};

}  // namespace

const Style& style_of(int number) {
  if (number < 0 || number >= kStyles) {
    throw std::invalid_argument("there is no style " + std::to_string(number) +
                                "; styles are 0 to " + std::to_string(kStyles - 1));
  }
  return kTable[static_cast<std::size_t>(number)];
}

}  // namespace tagmint::plot
