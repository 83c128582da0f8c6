#include "scene/light.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/background.h"
#include "scene/fill.h"

namespace tagmint::scene {
namespace {

using detect::Point;

/// The corners in clockwise order as seen.
std::vector<Point> clockwise(std::vector<Point> polygon) {
  double twice_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point next = polygon[(i + 1) % polygon.size()];
    twice_area += cross(polygon[i] - polygon[0], next - polygon[0]);
  }
  if (twice_area < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

}  // namespace

void apply_shading(const Shading& shading, const Window& window, GrayPlane& plane) {
  if (shading.strength == 0) return;
  const Ramp ramp(window.width, window.height, shading.angle_deg);
  for (int y = 0; y < plane.height; ++y) {
    float* row = plane.row(y);
    const double first = ramp.at(window.x_px(0), window.y_px(y));
    const double step = ramp.at(window.x_px(1), window.y_px(y)) - first;
    const auto light = static_cast<float>(1 - shading.strength * first);
    const auto loss = static_cast<float>(shading.strength * step);
    for (int x = 0; x < plane.width; ++x) row[x] *= light - loss * static_cast<float>(x);
  }
}

void apply_shadows(std::span<const Shadow> shadows, const Window& window, GrayPlane& plane) {
  Coverage coverage(1, 1);
  for (const Shadow& shadow : shadows) {
    const PixelBox box = cover(clockwise(shadow.polygon), window, coverage);
    for (int y = box.y0; y < box.y1; ++y) {
      Coverage::Row row = coverage.row(y - box.y0);
      float* level = plane.row(y);
      for (int x = box.x0; x < box.x1; ++x) {
        level[x] *= static_cast<float>(1 - (1 - shadow.light) * row.next());
      }
    }
  }
}

void apply_glare(std::span<const Glare> glare, const Window& window, GrayPlane& plane) {
  const auto falling = [](double distance_px, double radius_px) {
    return std::exp(-distance_px * distance_px / (2 * radius_px * radius_px));
  };
  std::vector<float> across(static_cast<std::size_t>(plane.width));
  for (const Glare& spot : glare) {
    for (int x = 0; x < plane.width; ++x) {
      across[x] = static_cast<float>(falling(window.x_px(x) - spot.centre.x, spot.radius_px));
    }
    for (int y = 0; y < plane.height; ++y) {
      const double down = falling(window.y_px(y) - spot.centre.y, spot.radius_px);
      const auto strength = static_cast<float>(spot.strength * down);
      float* row = plane.row(y);
      for (int x = 0; x < plane.width; ++x) row[x] += strength * across[x];
    }
  }
}

void apply_vignetting(double vignetting, const Window& window, GrayPlane& plane) {
  if (vignetting == 0) return;
  const Point middle{window.width / 2.0, window.height / 2.0};
  const double corner = dot(middle, middle);
  for (int y = 0; y < plane.height; ++y) {
    float* row = plane.row(y);
    for (int x = 0; x < plane.width; ++x) {
      const Point from_middle = Point{window.x_px(x), window.y_px(y)} - middle;
      row[x] *= static_cast<float>(1 - vignetting * dot(from_middle, from_middle) / corner);
    }
  }
}

}  // namespace tagmint::scene
