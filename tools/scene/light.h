#pragma once

#include <span>

#include "scene/gray_plane.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// What light does to the picture. Each function runs on the threads of the task arena that it is
/// called in; results do not depend on how many those are. Light is even within a pixel.

/// Multiplies the picture with the light that `shading` leaves.
void apply_shading(const Shading& shading, GrayPlane& plane);

/// Multiplies the picture with the light in the shadows; where they overlap, with both. A pixel on
/// a shadow's edge is in it by the share of its area.
void apply_shadows(std::span<const Shadow> shadows, GrayPlane& plane);

/// Adds the reflections.
void apply_glare(std::span<const Glare> glare, GrayPlane& plane);

/// Darkens towards the corners: light 1 - vignetting * (r / r of the corners)^2.
void apply_vignetting(double vignetting, GrayPlane& plane);

}  // namespace tagmint::scene
