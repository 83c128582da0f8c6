#pragma once

#include <cstdint>
#include <vector>

#include "tagmint/codec/export.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// A gray image that owns its pixels: 8 bits each, rows without padding.
class TAGMINT_API Image {
 public:
  Image() = default;
  /// All pixels `value`. Throws std::invalid_argument when a side is negative.
  Image(int width, int height, std::uint8_t value = 0);

  /// Changes the size, keeps the memory; the pixels are unspecified afterwards.
  void resize(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  std::uint8_t* row(int y) { return pixels_.data() + static_cast<std::size_t>(y) * width_; }
  const std::uint8_t* row(int y) const {
    return pixels_.data() + static_cast<std::size_t>(y) * width_;
  }
  std::uint8_t& at(int x, int y) { return row(y)[x]; }
  std::uint8_t at(int x, int y) const { return row(y)[x]; }

  ImageView view() const { return {pixels_.data(), width_, height_, width_}; }
  operator ImageView() const { return view(); }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace tagmint::detect
