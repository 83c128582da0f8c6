#include "io/row_format.h"

#include <fmt/format.h>

#include <stdexcept>

namespace tagmint::io {

void check_row_format(const RowFormat& format) {
  if (format.width < 1 || format.height < 1) {
    throw std::invalid_argument(
        fmt::format("an image of {} x {} pixels cannot be written; sides are 1 or more",
                    format.width, format.height));
  }
  if (format.bits != 1 && format.bits != 8) {
    throw std::invalid_argument(
        fmt::format("{} bits a pixel cannot be written; it is 1 or 8", format.bits));
  }
  if (!(format.dpi > 0 && format.dpi <= 1e6)) {
    throw std::invalid_argument(
        fmt::format("{} dpi cannot be; it is above 0 up to 1e6", format.dpi));
  }
}

std::vector<std::uint8_t> row_samples(std::span<const std::uint8_t> gray, const RowFormat& format) {
  std::vector<std::uint8_t> samples;
  if (format.bits == 1) {
    samples.resize((gray.size() + 7) / 8);
    for (std::size_t x = 0; x < gray.size(); ++x) {
      if (gray[x] >= 128) samples[x / 8] |= static_cast<std::uint8_t>(0x80u >> (x % 8));
    }
  } else if (format.transparent) {
    samples.resize(2 * gray.size());
    for (std::size_t x = 0; x < gray.size(); ++x) {
      samples[2 * x + 1] = static_cast<std::uint8_t>(255 - gray[x]);
    }
  } else {
    samples.assign(gray.begin(), gray.end());
  }
  return samples;
}

}  // namespace tagmint::io
