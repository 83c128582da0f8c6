#include "scene/marks.h"

#include <cmath>
#include <numbers>

namespace tagmint::scene {
namespace {

using detect::Point;

/// Corners of a half circle: a polygon of 48 in all is off by 0.2 % of its radius.
constexpr int kHalfCircle = 24;

/// The strip of the given radius about the line from a to b, clockwise as seen.
std::vector<Point> strip(Point a, Point b, double radius_px) {
  const double direction = std::atan2(b.y - a.y, b.x - a.x);
  std::vector<Point> outline;
  const auto half_circle = [&](Point centre, double from) {
    for (int i = 0; i <= kHalfCircle; ++i) {
      const double angle = from + std::numbers::pi * i / kHalfCircle;
      outline.push_back(centre + radius_px * Point{std::cos(angle), std::sin(angle)});
    }
  };
  half_circle(b, direction - std::numbers::pi / 2);
  half_circle(a, direction + std::numbers::pi / 2);
  return outline;
}

}  // namespace

std::vector<Patch> mark_patches(std::span<const Mark> marks) {
  std::vector<Patch> patches;
  for (const Mark& mark : marks) {
    const std::size_t strips = mark.path.size() > 1 ? mark.path.size() - 1 : 1;
    for (std::size_t i = 0; i < strips; ++i) {
      const Point from = mark.path[i];
      const Point to = mark.path.size() > 1 ? mark.path[i + 1] : from;
      patches.push_back({strip(from, to, mark.width_px / 2), mark.gray});
    }
  }
  return patches;
}

}  // namespace tagmint::scene
