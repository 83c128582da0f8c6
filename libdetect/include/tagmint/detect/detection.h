#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/homography.h"

namespace tagmint::detect {

/// Covariance of the corners (x0, y0, x1, ... y3), px^2, row-major 8 x 8, symmetric.
using CornerCovariance = std::array<double, 64>;

/// One tag found in an image. Coordinates are full-resolution pixels.
struct TAGMINT_API Detection {
  codec::SharedFamily family;
  codec::TagId id = 0;
  int hamming = 0;  ///< corrected bit errors
  double decision_margin =
      0;  ///< mean gray-level distance of the bits from the black/white threshold, 0..255; the
          ///< smaller of the white cells' mean and the black cells' mean
  double margin_to_noise = 0;  ///< decision_margin over the scatter of the border's cells
  /// Logarithm of how much more probable the tag is than something else in a border, from the cells
  /// one by one and from how often words are taken for tags of this family with as many errors.
  double log_odds = 0;
  bool inverted = false;  ///< printed with black for white; only where asked for
  bool mirrored = false;  ///< printed left for right; only where asked for. Corners and homography
                          ///< are those of the tag, so they go clockwise as seen.
  Point center;           ///< image of the tag's middle (0, 0)
  Corners corners;        ///< of the border square, in the order of kTagCorners
  Homography homography;  ///< tag [-1,1]^2 -> image; row-major scaled so that h22 = 1
  /// How far the corners may be from the truth, where the photometric step found them
  /// (docs/refinement.md); nothing where it did not run or was refused.
  std::optional<CornerCovariance> corner_covariance = {};
};

}  // namespace tagmint::detect
