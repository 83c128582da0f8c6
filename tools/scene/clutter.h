#pragma once

#include <cstdint>

#include "scene/gray_plane.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// Random convex shapes over one another, the large ones below. Sides are exact polygon areas.
///   seed   of the scene
///   cost   the pixels of each shape's box
GrayPlane draw_clutter(const ClutterBackground& clutter, int width, int height, std::uint64_t seed);

}  // namespace tagmint::scene
