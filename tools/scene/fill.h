#pragma once

#include <span>
#include <vector>

#include "scene/coverage.h"
#include "scene/gray_plane.h"

namespace tagmint::scene {

/// Paints polygons of one gray level over a picture, each pixel by the share of it that they cover.
class Painter {
 public:
  explicit Painter(GrayPlane& plane) : plane_(plane), coverage_(plane.width, plane.height) {}

  /// Corners clockwise as seen (y down), px; what lies outside the picture is cut off.
  ///   cost   the pixels of the polygon's box
  void fill(std::span<const detect::Point> polygon, double gray);

 private:
  GrayPlane& plane_;
  Coverage coverage_;
  std::vector<double> row_;
};

}  // namespace tagmint::scene
