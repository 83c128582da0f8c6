#pragma once

#include <span>
#include <vector>

#include "scene/fill.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// Marks as areas, in their order: each stretch of a path a strip with round ends, a path of one
/// point a disc.
std::vector<Patch> mark_patches(std::span<const Mark> marks);

}  // namespace tagmint::scene
