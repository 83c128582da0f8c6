#pragma once

#include <span>

#include "scene/gray_plane.h"
#include "scene/scene.h"
#include "scene/window.h"

namespace tagmint::scene {

/// What light does to a window of the picture; `plane` holds the window's samples. Light is even
/// within a sample.

/// Multiplies the picture with the light that `shading` leaves.
void apply_shading(const Shading& shading, const Window& window, GrayPlane& plane);

/// Multiplies the picture with the light in the shadows; where they overlap, with both. A sample on
/// a shadow's edge is in it by the share of its area.
void apply_shadows(std::span<const Shadow> shadows, const Window& window, GrayPlane& plane);

/// Adds the reflections.
void apply_glare(std::span<const Glare> glare, const Window& window, GrayPlane& plane);

/// Darkens towards the corners: light 1 - vignetting * (r / r of the corners)^2.
void apply_vignetting(double vignetting, const Window& window, GrayPlane& plane);

}  // namespace tagmint::scene
