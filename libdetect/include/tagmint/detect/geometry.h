#pragma once

#include <array>
#include <cmath>

#include "tagmint/codec/export.h"

namespace tagmint::detect {

/// A place or a direction in the plane; pixels unless said otherwise.
struct TAGMINT_API Point {
  double x = 0;
  double y = 0;

  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(double s, Point p) { return {s * p.x, s * p.y}; }
  friend bool operator==(const Point&, const Point&) = default;
};

inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
/// z of the cross product; positive when b is clockwise from a as seen (y down).
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline double length(Point p) { return std::hypot(p.x, p.y); }

/// The four corners of a tag's border square. Order of a decoded tag: bottom-left, bottom-right,
/// top-right, top-left of the upright tag, that is the tag points (-1,1) (1,1) (1,-1) (-1,-1);
/// counter-clockwise as seen.
using Corners = std::array<Point, 4>;

/// The tag points that `Corners` of a decoded tag are images of.
inline constexpr std::array<Point, 4> kTagCorners = {
    {{-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}};

/// Signed area by the shoelace formula; negative for corners in counter-clockwise order as seen (y
/// down).
TAGMINT_API double signed_area(const Corners& corners);

}  // namespace tagmint::detect
