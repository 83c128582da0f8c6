#include "support/measured_corners.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace tagmint::test {
namespace {

using detect::Corners;
using detect::ImageView;
using detect::Point;

/// Share of ink at a place, between the middles of the four nearest pixels.
double ink(ImageView page, Point p) {
  const double u = p.x - 0.5;
  const double v = p.y - 0.5;
  const int x = static_cast<int>(std::floor(u));
  const int y = static_cast<int>(std::floor(v));
  const auto at = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= page.width || j >= page.height) return 0.0;  // beyond is paper
    return (255 - page.at(i, j)) / 255.0;
  };
  const double fx = u - x;
  const double fy = v - y;
  return (1 - fy) * ((1 - fx) * at(x, y) + fx * at(x + 1, y)) +
         fy * ((1 - fx) * at(x, y + 1) + fx * at(x + 1, y + 1));
}

/// Distance of a black/white edge from `p` along `outwards`, both in px: half of the line from
/// -reach to +reach is black when the edge is at p.
double edge_offset(ImageView page, Point p, Point outwards, double reach, bool black_outside) {
  constexpr int kSteps = 400;
  double black = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = -reach + 2 * reach * (i + 0.5) / kSteps;
    black += ink(page, p + t * outwards) * 2 * reach / kSteps;
  }
  return black_outside ? reach - black : black - reach;
}

struct Side {
  Point at;
  Point along;
};

Point cut(const Side& a, const Side& b) {
  const double turn = cross(a.along, b.along);
  if (std::abs(turn) < 1e-9) throw std::logic_error("two sides of a square are parallel");
  return a.at + (cross(b.at - a.at, b.along) / turn) * a.along;
}

}  // namespace

Corners measured_corners(ImageView page, double px_a_mm, const Corners& near_mm, double cell_mm,
                         bool reversed) {
  const double cell = cell_mm * px_a_mm;
  std::array<Side, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point from = px_a_mm * near_mm[i];
    const Point to = px_a_mm * near_mm[(i + 1) % 4];
    const Point along = (1 / length(to - from)) * (to - from);
    // Counter-clockwise as seen, y down: the outside is to the right of each step.
    const Point outwards = {-along.y, along.x};
    const auto point_at = [&](Point p) {
      return p + edge_offset(page, p, outwards, 0.4 * cell, reversed) * outwards;
    };
    const Point first = point_at(from + 0.5 * cell * along);
    const Point last = point_at(to - 0.5 * cell * along);
    sides[i] = {first, last - first};
  }
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = (1 / px_a_mm) * cut(sides[(i + 3) % 4], sides[i]);
  }
  return corners;
}

}  // namespace tagmint::test
