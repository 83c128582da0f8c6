#pragma once

#include <span>
#include <vector>

#include "scene/coverage.h"
#include "scene/gray_plane.h"
#include "scene/window.h"

namespace tagmint::scene {

/// An area of one gray level.
struct Patch {
  std::vector<detect::Point> polygon;  ///< px, corners clockwise as seen (y down)
  double gray = 0;
};

/// What a polygon (px, clockwise as seen) covers of a window: `coverage` becomes that of the
/// samples in the box returned, which may be empty.
PixelBox cover(std::span<const detect::Point> polygon, const Window& window, Coverage& coverage);

/// Paints patches over the window's samples in their order, each sample by the share of it that the
/// patch covers; what lies outside is cut off.
///   cost   the samples of the patches' boxes
void paint(std::span<const Patch> patches, const Window& window, GrayPlane& plane);

}  // namespace tagmint::scene
