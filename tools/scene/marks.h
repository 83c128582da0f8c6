#pragma once

#include <span>

#include "scene/gray_plane.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// Lays marks over the picture, in their order: each stretch of a path as a strip with round ends,
/// a path of one point as a disc.
///   cost   the pixels of each strip's box
void draw_marks(std::span<const Mark> marks, GrayPlane& plane);

}  // namespace tagmint::scene
