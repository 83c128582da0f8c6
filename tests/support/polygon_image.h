#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image.h"

namespace tagmint::testing {

/// The part of a convex polygon on one side of an upright or level line: keeps points with
/// sign * (coordinate - bound) >= 0.
inline std::vector<detect::Point> clip(std::span<const detect::Point> polygon, bool by_x, int sign,
                                       double bound) {
  const auto inside_by = [&](detect::Point p) { return sign * ((by_x ? p.x : p.y) - bound); };
  std::vector<detect::Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const detect::Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double inside_a = inside_by(a), inside_b = inside_by(b);
    if (inside_a >= 0) kept.push_back(a);
    if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0)) {
      kept.push_back(a + (inside_a / (inside_a - inside_b)) * (b - a));
    }
  }
  return kept;
}

/// Area of the part of a convex polygon inside pixel (x, y), 0..1.
inline double coverage(std::span<const detect::Point> polygon, int x, int y) {
  std::vector<detect::Point> part = clip(polygon, true, 1, x);
  part = clip(part, true, -1, x + 1.0);
  part = clip(part, false, 1, y);
  part = clip(part, false, -1, y + 1.0);
  double twice = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    twice += detect::cross(part[i], part[(i + 1) % part.size()]);
  }
  return std::abs(twice) / 2;
}

/// Paints a convex polygon as an ideal camera sees it: each pixel mixes both gray levels by exact
/// area, rounded to the nearest whole level.
inline void paint_polygon(detect::Image& image, std::span<const detect::Point> polygon,
                          double gray) {
  double left = image.width(), right = 0, top = image.height(), bottom = 0;
  for (const detect::Point p : polygon) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
  const int x_end = std::min(image.width(), static_cast<int>(std::ceil(right)));
  const int y_end = std::min(image.height(), static_cast<int>(std::ceil(bottom)));
  for (int y = std::max(0, static_cast<int>(std::floor(top))); y < y_end; ++y) {
    for (int x = std::max(0, static_cast<int>(std::floor(left))); x < x_end; ++x) {
      const double share = coverage(polygon, x, y);
      const double mixed = image.at(x, y) * (1 - share) + gray * share;
      image.at(x, y) = static_cast<std::uint8_t>(std::lround(mixed));
    }
  }
}

/// Corners of a square, counter-clockwise as seen from its bottom-left corner on.
///   turn_rad   clockwise as seen
inline detect::Corners square_corners(detect::Point center, double side, double turn_rad = 0) {
  detect::Corners corners;
  for (int i = 0; i < 4; ++i) {
    const detect::Point p = 0.5 * side * detect::kTagCorners[i];
    corners[i] = center + detect::Point{p.x * std::cos(turn_rad) - p.y * std::sin(turn_rad),
                                        p.x * std::sin(turn_rad) + p.y * std::cos(turn_rad)};
  }
  return corners;
}

}  // namespace tagmint::testing
