#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "tagmint/codec/export.h"

namespace tagmint::detect {

/// A gray image that somebody else owns: 8 bits a pixel, rows `stride` bytes apart (negative =
/// bottom row first). Pixel (0, 0) covers [0,1) x [0,1), its centre is (0.5, 0.5); x right, y down
/// (docs/conventions.md).
struct TAGMINT_API ImageView {
  const std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;

  const std::uint8_t* row(int y) const {
    assert(y >= 0 && y < height);
    return data + y * stride;
  }
  std::uint8_t at(int x, int y) const {
    assert(x >= 0 && x < width);
    return row(y)[x];
  }
  bool empty() const { return width <= 0 || height <= 0; }
};

}  // namespace tagmint::detect
