#pragma once

#include <cstdint>

#include "scene/gray_plane.h"
#include "tagmint/detect/image.h"

namespace tagmint::scene {

/// What the camera does to the picture behind the lens. Each function runs on the threads of the
/// task arena that it is called in; results do not depend on how many those are.

/// Counts electrons: a level becomes a Poisson number of mean level * electrons_per_level, over
/// electrons_per_level. 0 = none; levels below 0 have no electrons.
void apply_shot_noise(double electrons_per_level, std::uint64_t seed, GrayPlane& plane);

/// Light to gray level, 255 (light / 255)^(1 / gamma); light beyond white is white.
void apply_gamma(double gamma, GrayPlane& plane);

/// Adds Gaussian noise of `sigma` gray levels, rounds to the nearest level and clips to 0..255.
detect::Image add_noise_and_round(const GrayPlane& plane, double sigma, std::uint64_t seed);

}  // namespace tagmint::scene
