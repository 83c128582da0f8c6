#pragma once

#include <cstdint>
#include <vector>

#include "scene/fill.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// Random convex shapes over one another, the large ones below; the first one is the whole picture.
///   seed   of the scene
std::vector<Patch> clutter_patches(const ClutterBackground& clutter, int width, int height,
                                   std::uint64_t seed);

}  // namespace tagmint::scene
