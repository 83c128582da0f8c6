#include "tagmint/detect/image.h"

#include <fmt/format.h>

#include <stdexcept>

namespace tagmint::detect {

Image::Image(int width, int height, std::uint8_t value) {
  resize(width, height);
  pixels_.assign(pixels_.size(), value);
}

void Image::resize(int width, int height) {
  if (width < 0 || height < 0) {
    throw std::invalid_argument(
        fmt::format("an image of {} x {} pixels cannot be; sides are 0 or more", width, height));
  }
  width_ = width;
  height_ = height;
  pixels_.resize(static_cast<std::size_t>(width) * height);
}

}  // namespace tagmint::detect
