#pragma once

#include "tagmint/codec/export.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// Pinhole camera with Brown-Conrady distortion: x right, y down, z forward. Pixel coordinates as
/// in ImageView, so a principal point measured with pixel centres at whole numbers (OpenCV) needs
/// 0.5 added.
struct TAGMINT_API Camera {
  double fx = 0;  ///< focal length, px, > 0
  double fy = 0;  ///< px, > 0
  double cx = 0;  ///< principal point, px
  double cy = 0;
  double k1 = 0;  ///< radial, r^2
  double k2 = 0;  ///< radial, r^4
  double p1 = 0;  ///< tangential
  double p2 = 0;
  double k3 = 0;  ///< radial, r^6

  bool distorts() const { return k1 != 0 || k2 != 0 || p1 != 0 || p2 != 0 || k3 != 0; }
  /// Normalised image plane (x/z, y/z) -> pixel, distortion included.
  Point to_pixel(Point normalised) const;
  /// Pixel -> normalised image plane, distortion taken out by fixed-point iteration to 1e-12 or 50
  /// steps.
  Point to_normalised(Point pixel) const;
};

/// Throws std::invalid_argument unless fx and fy are positive and all numbers finite.
TAGMINT_API void check_camera(const Camera& camera);

}  // namespace tagmint::detect
