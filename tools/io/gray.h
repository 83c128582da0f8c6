#pragma once

#include <cstdint>

namespace tagmint::io {

/// Rec. 601 luma of a colour, 0.299 R + 0.587 G + 0.114 B, rounded; the weights are in 1/65536 and
/// sum to one, so gray stays itself. Samples of up to 16 bits.
constexpr std::uint32_t luma(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return static_cast<std::uint32_t>((std::uint64_t{19595} * red + std::uint64_t{38470} * green +
                                     std::uint64_t{7471} * blue + 32768) >>
                                    16);
}

/// A sample of 0..top seen through alpha 0..top over white.
constexpr std::uint32_t over_white(std::uint32_t value, std::uint32_t alpha, std::uint32_t top) {
  return static_cast<std::uint32_t>(
      (std::uint64_t{value} * alpha + std::uint64_t{top} * (top - alpha) + top / 2) / top);
}

/// A sample of 0..top as 0..255, rounded. top <= 65535.
constexpr std::uint8_t to_8_bits(std::uint32_t value, std::uint32_t top) {
  return static_cast<std::uint8_t>((value * 255 + top / 2) / top);
}

}  // namespace tagmint::io
