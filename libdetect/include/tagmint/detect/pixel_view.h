#pragma once

#include <cstddef>
#include <cstdint>

#include "tagmint/codec/export.h"
#include "tagmint/detect/image.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Pixels of 8-bit samples in any layout that somebody else owns: sample c of pixel (x, y) is
/// data[y * stride + x * step + c]. Covers gray and luma planes (step 1), interleaved gray, RGB,
/// BGR and their kinds with alpha, packed luma such as YUYV (step 2), single planes of planar
/// pictures, and rows in any order (negative stride).
struct TAGMINT_API PixelView {
  const std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next
  std::ptrdiff_t step = 1;    ///< bytes from one pixel to the next
  std::ptrdiff_t red = 0;     ///< where a pixel has its red, green and blue sample; three equal
  std::ptrdiff_t green = 0;   ///< ones mean a gray or luma sample there
  std::ptrdiff_t blue = 0;
};

/// The gray picture of the pixels, for Detector::detect(): Rec. 601 luma, 0.299 R + 0.587 G +
/// 0.114 B, rounded. Gray samples a byte apart are taken as they are, without a copy.
///   scratch   holds the copy otherwise, and keeps its memory from one picture to the next
///   returns   a view of the pixels or of `scratch`
///   errors    std::invalid_argument when there are pixels but no data
///   cost      one pass over the pixels
TAGMINT_API ImageView gray_view(const PixelView& pixels, Image& scratch);

}  // namespace tagmint::detect
