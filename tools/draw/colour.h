#pragma once

#include <cmath>
#include <cstdint>

namespace tagmint::draw {

/// Red, green and blue, 0..1 each.
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

/// Bright colours that differ well between neighbouring indexes: hues a golden section apart.
inline Colour distinct_colour(std::uint64_t index) {
  const double hue = std::fmod(static_cast<double>(index % 100000) * 0.6180339887498949, 1.0) * 6;
  const double lightness[3] = {1.0, 0.75, 0.9};
  const double full = lightness[index % 3];
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue, 6.0);
    const double ramp = std::fmin(std::fmin(k, 4 - k), 1.0);  // HSV to RGB, saturation 0.8
    return full * (1 - 0.8 * std::fmax(0.0, ramp));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace tagmint::draw
