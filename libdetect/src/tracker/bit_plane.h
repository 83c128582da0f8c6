#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tagmint::detect {

/// One bit a pixel, rows of 64-bit words, the leftmost pixel of a word in its lowest bit. Around
/// the picture lie bits that are zero: a row above, kRowsBelow rows below, a word before each row
/// and at least one behind it, so that loops may look beyond the edges.
class BitPlane {
 public:
  static constexpr int kRowsBelow = 8;

  /// Changes the size and keeps the memory. The bits of the picture are unspecified afterwards,
  /// those around it zero: who writes the picture's bits leaves them so.
  void resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    // Kernels write whole vectors of up to 512 bits.
    stride_ = (static_cast<std::size_t>(width) + 511) / 512 * 8 + 8;
    words_.assign(stride_ * (static_cast<std::size_t>(height) + kRowsBelow + 1), 0);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  /// Words from one row to the next.
  std::size_t stride() const { return stride_; }
  /// Words of a row that hold pixels.
  int words() const { return (width_ + 63) / 64; }

  /// Row y, -1 <= y < height + kRowsBelow; word -1 and words() may be read.
  std::uint64_t* row(int y) {
    assert(y >= -1 && y < height_ + kRowsBelow);
    return words_.data() + stride_ * static_cast<std::size_t>(y + 1) + 1;
  }
  const std::uint64_t* row(int y) const { return const_cast<BitPlane*>(this)->row(y); }

  bool at(int x, int y) const { return row(y)[x >> 6] >> (x & 63) & 1; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::size_t stride_ = 0;
  std::vector<std::uint64_t> words_;
};

/// Bits of a row from bit x on: bit i of the result is pixel x + i, for i below kWindowBits; the
/// others may be anything. -64 <= x.
inline constexpr int kWindowBits = 57;
inline std::uint64_t bits_from(const std::uint64_t* row, int x) {
  if constexpr (std::endian::native == std::endian::little) {
    std::uint64_t window;
    std::memcpy(&window, reinterpret_cast<const unsigned char*>(row) + (x >> 3), sizeof window);
    return window >> (x & 7);
  } else {
    const int shift = x & 63;
    // In two steps, since a shift by 64 is none.
    return row[x >> 6] >> shift | row[(x >> 6) + 1] << 1 << (63 - shift);
  }
}

}  // namespace tagmint::detect
