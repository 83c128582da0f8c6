#include "identify/reduce.h"

#include <algorithm>

namespace tagmint::identify {

detect::Image half_size(detect::ImageView picture) {
  if (picture.width < 2 || picture.height < 2) return {};
  detect::Image half(picture.width / 2, picture.height / 2);
  for (int y = 0; y < half.height(); ++y) {
    const std::uint8_t* top = picture.row(2 * y);
    const std::uint8_t* bottom = picture.row(2 * y + 1);
    for (int x = 0; x < half.width(); ++x) {
      const int sum = top[2 * x] + top[2 * x + 1] + bottom[2 * x] + bottom[2 * x + 1];
      half.at(x, y) = static_cast<std::uint8_t>((sum + 2) / 4);
    }
  }
  return half;
}

detect::Image with_margin(detect::ImageView picture, int margin_px, std::uint8_t gray) {
  detect::Image larger(picture.width + 2 * margin_px, picture.height + 2 * margin_px, gray);
  for (int y = 0; y < picture.height; ++y) {
    std::copy_n(picture.row(y), picture.width, larger.row(y + margin_px) + margin_px);
  }
  return larger;
}

}  // namespace tagmint::identify
