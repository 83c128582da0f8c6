#include "tagmint/detect/camera.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace tagmint::detect {
namespace {

/// [Brown1966] as OpenCV and the robotics world write it: radial factor and tangential shift.
struct Distortion {
  double radial;
  Point tangential;
};

Distortion distortion_at(const Camera& c, Point p) {
  const double r2 = dot(p, p);
  return {1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3)),
          {2 * c.p1 * p.x * p.y + c.p2 * (r2 + 2 * p.x * p.x),
           c.p1 * (r2 + 2 * p.y * p.y) + 2 * c.p2 * p.x * p.y}};
}

}  // namespace

Point Camera::to_pixel(Point normalised) const {
  Point p = normalised;
  if (distorts()) {
    const Distortion d = distortion_at(*this, normalised);
    p = d.radial * normalised + d.tangential;
  }
  return {fx * p.x + cx, fy * p.y + cy};
}

Point Camera::to_normalised(Point pixel) const {
  const Point distorted = {(pixel.x - cx) / fx, (pixel.y - cy) / fy};
  if (!distorts()) return distorted;
  constexpr int kMaxSteps = 50;
  constexpr double kConverged = 1e-12;
  Point p = distorted;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Distortion d = distortion_at(*this, p);
    const Point next = (1 / d.radial) * (distorted - d.tangential);
    const double moved = length(next - p);
    p = next;
    if (moved < kConverged) break;
  }
  return p;
}

void check_camera(const Camera& camera) {
  const std::array<double, 9> numbers = {camera.fx, camera.fy, camera.cx, camera.cy, camera.k1,
                                         camera.k2, camera.p1, camera.p2, camera.k3};
  for (const double number : numbers) {
    if (!std::isfinite(number)) {
      throw std::invalid_argument(
          "a camera's numbers must be finite; one of fx, fy, cx, cy, k1, "
          "k2, p1, p2, k3 is not");
    }
  }
  if (camera.fx <= 0 || camera.fy <= 0) {
    throw std::invalid_argument(
        fmt::format("the focal lengths {} and {} px are not possible; both must be above 0",
                    camera.fx, camera.fy));
  }
}

}  // namespace tagmint::detect
