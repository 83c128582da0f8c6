#include "numerics/polygon_overlap.h"

#include <array>
#include <cmath>

namespace tagmint::detect {
namespace {

/// Corners in order. A cut of a convex polygon by a line adds at most one corner; of any polygon
/// of n corners at most n / 2, so that even a quad that is not convex stays below 20 in four cuts.
struct Polygon {
  std::array<Point, 20> corner;
  int size = 0;

  void add(Point p) { corner[size++] = p; }
};

/// The part of `polygon` on the positive side of the directed line from a to b.
Polygon cut(const Polygon& polygon, Point a, Point b) {
  Polygon kept;
  for (int i = 0; i < polygon.size; ++i) {
    const Point p = polygon.corner[i];
    const Point q = polygon.corner[(i + 1) % polygon.size];
    const double side_p = cross(b - a, p - a);
    const double side_q = cross(b - a, q - a);
    if (side_p >= 0) kept.add(p);
    if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) {
      kept.add(p + side_p / (side_p - side_q) * (q - p));
    }
  }
  return kept;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (int i = 0; i < polygon.size; ++i) {
    twice += cross(polygon.corner[i] - polygon.corner[0],
                   polygon.corner[(i + 1) % polygon.size] - polygon.corner[0]);
  }
  return std::abs(twice) / 2;
}

}  // namespace

double overlap_area(const Corners& a, const Corners& b) {
  Polygon common;
  for (const Point p : a) common.add(p);
  const bool positive = signed_area(b) > 0;
  for (int i = 0; i < 4; ++i) {
    const Point from = b[i];
    const Point to = b[(i + 1) % 4];
    common = positive ? cut(common, from, to) : cut(common, to, from);
  }
  return area(common);
}

}  // namespace tagmint::detect
