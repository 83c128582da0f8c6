#pragma once

#include <cstdint>
#include <vector>

#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage 1: the gray image -> the smaller, blurred or sharpened picture that quads are looked for
/// in.
struct PreprocessOptions {
  double decimate = 1.0;  ///< >= 1, fractions allowed; a working pixel is this many pixels wide
  double blur_sigma_px = 0.0;  ///< of the working image; > 0 blurs, < 0 sharpens, 0 leaves as it is
};

/// The full pixels that one working pixel spans along a row, and what share of the first and of the
/// last one; those between count whole.
struct PixelSpan {
  int first = 0;
  int last = 0;
  float first_share = 0;
  float last_share = 0;
};

/// Buffers that preprocess() keeps from one image to the next.
struct PreprocessScratch {
  std::vector<std::uint32_t> whole_sums;  ///< decimation by a whole number: column sums of a row
  std::vector<float> weighted_sums;       ///< decimation by a fraction: weighted column sums
  std::vector<PixelSpan> spans;           ///< decimation by a fraction: by working column
  std::vector<std::uint32_t> kernel;      ///< blur: weights, 16 fractional bits, sum 1
  std::vector<std::uint8_t> padded_row;   ///< blur: a row with its end pixels repeated
  std::vector<std::uint16_t> horizontal;  ///< blur: image after the horizontal pass, 8.8 bits
  std::vector<std::uint32_t> sums;        ///< blur: one row of weighted sums
  Image blurred;                          ///< blur: the result, before it becomes `working`
};

/// How coordinates of the working image and of the full image belong together. Working pixel (i, j)
/// is the mean gray value of the square [i f, (i + 1) f) x [j f, (j + 1) f) of the full image, so
/// with pixel (0, 0) covering [0,1) x [0,1) in both the map is a pure scaling, without an offset.
struct WorkingScale {
  double factor = 1.0;  ///< PreprocessOptions::decimate
  Point to_full(Point working) const { return factor * working; }
  Point to_working(Point full) const { return (1.0 / factor) * full; }
};

/// Decimates, then blurs (or sharpens: twice the image less its blur).
///   full      any size, any stride
///   working   takes the result when there is something to do; floor(side / decimate) pixels a side
///   returns   the picture to go on with: a view of `working`, or `full` itself when decimate is 1
///             and blur_sigma_px is 0
///   errors    std::invalid_argument when decimate is below 1 or an option is not finite
///   cost      decimation reads each full pixel once; the blur is separable, 2 x (6 sigma + 1)
///             multiplications a working pixel
[[nodiscard]] ImageView preprocess(ImageView full, const PreprocessOptions& options,
                                   PreprocessScratch& scratch, Image& working);

}  // namespace tagmint::detect
