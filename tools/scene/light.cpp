#include "scene/light.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/background.h"
#include "scene/coverage.h"
#include "scene/rows.h"

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

void apply_shading(const Shading& shading, GrayPlane& plane) {
  if (shading.strength == 0) return;
  const Ramp ramp(plane.width, plane.height, shading.angle_deg);
  for_each_row(plane.height, [&](int y) {
    float* row = plane.row(y);
    for (int x = 0; x < plane.width; ++x) {
      row[x] *= static_cast<float>(1 - shading.strength * ramp.at(x, y));
    }
  });
}

void apply_shadows(std::span<const Shadow> shadows, GrayPlane& plane) {
  if (shadows.empty()) return;
  Coverage coverage(plane.width, plane.height);
  std::vector<double> covered;
  for (const Shadow& shadow : shadows) {
    coverage.add(clockwise(shadow.polygon));
    const PixelBox box = coverage.box();
    covered.resize(box.empty() ? 0 : static_cast<std::size_t>(box.x1 - box.x0));
    for (int y = box.y0; y < box.y1 && !box.empty(); ++y) {
      coverage.read_row(y, covered);
      float* level = plane.row(y) + box.x0;
      for (std::size_t i = 0; i < covered.size(); ++i) {
        level[i] *= static_cast<float>(1 - (1 - shadow.light) * covered[i]);
      }
    }
    coverage.clear();
  }
}

void apply_glare(std::span<const Glare> glare, GrayPlane& plane) {
  if (glare.empty()) return;
  for_each_row(plane.height, [&](int y) {
    float* row = plane.row(y);
    for (const Glare& spot : glare) {
      for (int x = 0; x < plane.width; ++x) {
        const double dx = (x + 0.5 - spot.centre.x) / spot.radius_px;
        const double dy = (y + 0.5 - spot.centre.y) / spot.radius_px;
        row[x] += static_cast<float>(spot.strength * std::exp(-(dx * dx + dy * dy) / 2));
      }
    }
  });
}

void apply_vignetting(double vignetting, GrayPlane& plane) {
  if (vignetting == 0) return;
  const Point middle{plane.width / 2.0, plane.height / 2.0};
  const double corner = dot(middle, middle);
  for_each_row(plane.height, [&](int y) {
    float* row = plane.row(y);
    for (int x = 0; x < plane.width; ++x) {
      const Point from_middle = Point{x + 0.5, y + 0.5} - middle;
      row[x] *= static_cast<float>(1 - vignetting * dot(from_middle, from_middle) / corner);
    }
  });
}

}  // namespace tagmint::scene
