#pragma once

#include <array>

#include "refine/tag_pattern.h"

namespace tagmint::detect {

/// What decides the gray values of a tag's pixels once its word is known (docs/refinement.md).
/// Places are *frame* coordinates: pixels about the tag's middle, divided by about half its size.
struct PhotometricParameters {
  /// Frame -> cells from the tag's outer edge, row-major without the last entry, which is 1.
  std::array<double, 8> to_cells{};
  double black = 0;     ///< gray level of black in the middle of the tag
  double contrast = 1;  ///< gray level of white there, less `black`
  double light_x = 0;   ///< light falls off as 1 + light_x x + light_y y over the frame
  double light_y = 0;
  double log_spread =
      0;             ///< ln of the point-spread's standard deviation in px, pixel area included
  double tails = 0;  ///< shape of the point-spread, see edge_profile()
  double tone = 0;   ///< share t of white appears as t + tone t (1 - t)
};

/// Places of the parameters in vectors and matrices: 0..7 to_cells, then
inline constexpr int kBlackLevel = 8, kContrast = 9, kLightX = 10, kLightY = 11, kLogSpread = 12,
                     kTails = 13, kTone = 14;
inline constexpr int kPhotometricParameters = 15;
using PhotometricVector = std::array<double, kPhotometricParameters>;

/// Parameters moved by `step`.
PhotometricParameters moved(const PhotometricParameters& parameters, const PhotometricVector& step);

/// A pixel that takes part, with what does not change while the parameters are found.
struct PhotometricPixel {
  double x = 0;  ///< frame coordinates of the pixel's centre
  double y = 0;
  double gray = 0;
  int line_x = 0;  ///< the first grid lines that count for it, TagPattern::first_line()
  int line_y = 0;
  double across_x = 1;  ///< px from one grid line x = const to the next, at right angles to them
  double across_y = 1;  ///< the same of lines y = const
  double cosine = 0;    ///< of the angle between the gradients of the two cell coordinates
  double weight = 1;
};

/// The gray value that the parameters give a pixel, and its derivatives.
struct PhotometricPrediction {
  double gray = 0;
  PhotometricVector slope{};
};

/// The plain reference of the kernels: the same formulas, a pixel at a time.
PhotometricPrediction predict(const TagPattern& pattern, const PhotometricPixel& pixel,
                              const PhotometricParameters& parameters);

}  // namespace tagmint::detect
