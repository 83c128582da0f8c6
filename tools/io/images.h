#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tagmint/detect/image.h"

namespace tagmint::io {

/// A colour image: 3 bytes a pixel (red, green, blue), rows without padding.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  RgbImage() = default;
  RgbImage(int w, int h) : width(w), height(h), rgb(std::size_t(w) * h * 3) {}
  std::uint8_t* pixel(int x, int y) { return rgb.data() + (std::size_t(y) * width + x) * 3; }
  const std::uint8_t* pixel(int x, int y) const {
    return rgb.data() + (std::size_t(y) * width + x) * 3;
  }
};

}  // namespace tagmint::io
