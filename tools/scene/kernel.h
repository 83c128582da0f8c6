#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace tagmint::scene {

/// A square of weights about its middle, 2 * radius + 1 on a side, sum 1.
struct Kernel {
  int radius = 0;
  std::vector<double> weights;

  explicit Kernel(int r) : radius(r), weights(static_cast<std::size_t>(2 * r + 1) * (2 * r + 1)) {}
  int side() const { return 2 * radius + 1; }
  double& at(int dx, int dy) { return weights[index(dx, dy)]; }
  double at(int dx, int dy) const { return weights[index(dx, dy)]; }

 private:
  std::size_t index(int dx, int dy) const {
    return static_cast<std::size_t>(dy + radius) * side() + (dx + radius);
  }
};

/// A line about the middle on a grid of `scale` steps a pixel, each of its points shared between
/// the four nearest samples.
Kernel line_kernel(const MotionBlur& motion, int scale);

/// A disc about the middle on such a grid, samples weighted by the area that it covers of them; a
/// little smaller than the radius, so that its variance is that of the disc.
Kernel disc_kernel(double radius_px, int scale);

/// One after the other.
Kernel combined(const Kernel& a, const Kernel& b);

/// A kernel that is `line` along rows and columns; line[k] counts at k and -k.
Kernel separable_kernel(const std::vector<double>& line);

}  // namespace tagmint::scene
