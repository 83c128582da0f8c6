#pragma once

#include <vector>

#include "scene/gray_plane.h"

namespace tagmint::scene {

/// Weights of a Gaussian on a grid, from the middle outwards (weights[0] + 2 * the others = 1): its
/// samples, and below 0.8 grid steps, where these have too small a variance, the discrete Gaussian.
/// The variance is sigma^2 to 1e-3 of it and better; what is cut off is below 1e-6.
///   sigma      grid steps, >= 0
///   source     [Lindeberg1990]: e^-t I_n(t) with t = sigma^2, by downward recurrence
std::vector<double> gaussian_weights(double sigma);

/// A Gaussian blur between finished pixels; beyond its edges the picture goes on with the edge
/// pixels. Runs on the threads of the task arena that it is called in.
void apply_blur(double sigma_px, GrayPlane& plane);

}  // namespace tagmint::scene
