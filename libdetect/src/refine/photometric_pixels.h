#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "refine/photometric_model.h"

namespace tagmint::detect {

/// Pixels are worked on in blocks of so many, whatever the vectors of the machine, so that sums
/// come out the same everywhere.
inline constexpr int kPixelBlock = 16;

/// Pixels that take part in a fit, one array a quantity (PhotometricPixel says what they mean),
/// padded to whole blocks with pixels of no weight.
class PhotometricPixels {
 public:
  /// Forgets all pixels and makes room for `most`, which is rounded up to whole blocks and one
  /// more.
  void reset(std::size_t most);

  /// How many pixels there are, and how many blocks they fill once padded.
  std::size_t size() const { return size_; }
  std::size_t blocks() const { return (size_ + kPixelBlock - 1) / kPixelBlock; }
  std::size_t capacity() const { return x.size() - kPixelBlock; }

  /// Adds one pixel; size() < capacity().
  void add(const PhotometricPixel& pixel, const CellSurroundings& around);
  /// Takes over pixels written to the arrays behind size().
  void grow(std::size_t count) { size_ += count; }
  /// Gives the pixels that fill up the last block no weight and harmless other values.
  void pad();
  PhotometricPixel pixel(std::size_t i) const;

  std::vector<float> x, y, gray, line_x, line_y, across_x, across_y, cosine, weight;
  std::array<std::vector<std::uint32_t>, kMaxPatternWords> pattern;
  std::vector<std::int32_t> columns;  ///< scratch of choose_pixels(), as long as the others

 private:
  std::size_t size_ = 0;
};

}  // namespace tagmint::detect
