#pragma once

#include <cstdint>
#include <vector>

#include "scene/gray_plane.h"
#include "scene/scene.h"
#include "tagmint/detect/image.h"

namespace tagmint::scene {

/// What the camera does to the picture. Each function runs on the threads of the task arena that it
/// is called in; results do not depend on how many those are.

/// Weights of the discrete Gaussian, from the middle outwards (weights[0] + 2 * the others = 1).
/// Its variance is sigma^2 exactly, also where sigma is less than a pixel; what is cut off is below
/// 1e-9.
///   sigma_px   >= 0
///   source     [Lindeberg1990]: e^-t I_n(t) with t = sigma^2, by downward recurrence
std::vector<double> gaussian_weights(double sigma_px);

/// Gaussian blur; beyond its edges the picture goes on with the edge pixels.
void apply_blur(double sigma_px, GrayPlane& plane);

/// Moves the picture during the exposure: the mean over a line about each pixel, so that what is
/// seen is where the middle of the exposure had it. Beyond its edges the picture goes on with the
/// edge pixels.
///   cost   about two multiplications a pixel for each pixel of the line
void apply_motion_blur(const MotionBlur& motion, GrayPlane& plane);

/// Light to gray level, 255 (light / 255)^(1 / gamma); light beyond white is white.
void apply_gamma(double gamma, GrayPlane& plane);

/// Adds Gaussian noise of `sigma` gray levels, rounds to the nearest level and clips to 0..255.
detect::Image add_noise_and_round(const GrayPlane& plane, double sigma, std::uint64_t seed);

}  // namespace tagmint::scene
