#include "scene/kernel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "scene/coverage.h"

namespace tagmint::scene {

using detect::Point;

Kernel line_kernel(const MotionBlur& motion, int scale) {
  constexpr int kPointsPerStep = 16;
  const double angle = motion.angle_deg * std::numbers::pi / 180;
  const double length = motion.length_px * scale;
  const Point half = length / 2 * Point{std::cos(angle), std::sin(angle)};
  const int points = std::max(2, static_cast<int>(std::ceil(length * kPointsPerStep)));
  Kernel kernel(static_cast<int>(std::ceil(length / 2)) + 1);
  for (int i = 0; i < points; ++i) {
    const Point p = (2 * (i + 0.5) / points - 1) * half;
    const int left = static_cast<int>(std::floor(p.x)), top = static_cast<int>(std::floor(p.y));
    const double fx = p.x - left, fy = p.y - top;
    kernel.at(left, top) += (1 - fx) * (1 - fy) / points;
    kernel.at(left + 1, top) += fx * (1 - fy) / points;
    kernel.at(left, top + 1) += (1 - fx) * fy / points;
    kernel.at(left + 1, top + 1) += fx * fy / points;
  }
  return kernel;
}

Kernel disc_kernel(double radius_px, int scale) {
  // A disc's variance along a line is r^2 / 4; samples of even weight add 1/12 of a squared step.
  const double radius = radius_px * scale;
  const double drawn = std::sqrt(std::max(1e-6, radius * radius - 1.0 / 3));
  Kernel kernel(static_cast<int>(std::ceil(drawn + 0.5)));
  constexpr int kCorners = 128;
  // Of the disc's area.
  const double reach = drawn * std::sqrt(2 * std::numbers::pi / kCorners /
                                         std::sin(2 * std::numbers::pi / kCorners));
  const double middle = kernel.radius + 0.5;
  std::vector<Point> outline;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    outline.push_back({middle + reach * std::cos(angle), middle + reach * std::sin(angle)});
  }
  Coverage coverage(kernel.side(), kernel.side());
  coverage.add(outline);
  for (int y = -kernel.radius; y <= kernel.radius; ++y) {
    Coverage::Row row = coverage.row(y + kernel.radius);
    for (int x = -kernel.radius; x <= kernel.radius; ++x) {
      kernel.at(x, y) = row.next() / coverage.total_area();
    }
  }
  return kernel;
}

Kernel combined(const Kernel& a, const Kernel& b) {
  Kernel kernel(a.radius + b.radius);
  for (int ay = -a.radius; ay <= a.radius; ++ay) {
    for (int ax = -a.radius; ax <= a.radius; ++ax) {
      const double weight = a.at(ax, ay);
      if (weight == 0) continue;
      for (int by = -b.radius; by <= b.radius; ++by) {
        for (int bx = -b.radius; bx <= b.radius; ++bx) {
          kernel.at(ax + bx, ay + by) += weight * b.at(bx, by);
        }
      }
    }
  }
  return kernel;
}

Kernel separable_kernel(const std::vector<double>& line) {
  Kernel kernel(static_cast<int>(line.size()) - 1);
  for (int y = -kernel.radius; y <= kernel.radius; ++y) {
    for (int x = -kernel.radius; x <= kernel.radius; ++x) {
      kernel.at(x, y) =
          line[static_cast<std::size_t>(std::abs(x))] * line[static_cast<std::size_t>(std::abs(y))];
    }
  }
  return kernel;
}

}  // namespace tagmint::scene
