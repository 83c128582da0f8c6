#pragma once

#include <vector>

#include "tagmint/codec/family.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/homography.h"

namespace tagmint::detect {

/// One tag found in an image. Coordinates are full-resolution pixels.
struct Detection {
  codec::SharedFamily family;
  codec::TagId id = 0;
  int hamming = 0;  ///< corrected bit errors
  double decision_margin =
      0;  ///< mean gray-level distance of the bits from the black/white threshold, 0..255; the
          ///< smaller of the white cells' mean and the black cells' mean
  Point center;           ///< image of the tag's middle (0, 0)
  Corners corners;        ///< of the border square, in the order of kTagCorners
  Homography homography;  ///< tag [-1,1]^2 -> image; row-major scaled so that h22 = 1
};

}  // namespace tagmint::detect
