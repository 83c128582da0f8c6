#include "tagmint/detect/pixel_view.h"

#include <fmt/format.h>

#include <stdexcept>

namespace tagmint::detect {
namespace {

/// The weights are in 1/65536 and sum to one, so gray stays itself.
std::uint8_t luma(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return static_cast<std::uint8_t>((19595 * red + 38470 * green + 7471 * blue + 32768) >> 16);
}

}  // namespace

ImageView gray_view(const PixelView& p, Image& scratch) {
  if (p.width <= 0 || p.height <= 0) return {};
  if (!p.data) {
    throw std::invalid_argument(
        fmt::format("pixels of {} x {} without data cannot be", p.width, p.height));
  }
  const bool gray = p.red == p.green && p.green == p.blue;
  if (gray && p.step == 1) return {p.data + p.red, p.width, p.height, p.stride};
  scratch.resize(p.width, p.height);
  for (int y = 0; y < p.height; ++y) {
    const std::uint8_t* from = p.data + y * p.stride;
    std::uint8_t* const to = scratch.row(y);
    for (int x = 0; x < p.width; ++x, from += p.step) {
      to[x] = gray ? from[p.red] : luma(from[p.red], from[p.green], from[p.blue]);
    }
  }
  return scratch;
}

}  // namespace tagmint::detect
