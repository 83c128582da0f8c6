#include "pipeline/outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tagmint::detect {
namespace {

/// Bounds for the points of a cluster in units of points_around(). Tags in photographs have 0.69 to
/// 1.08, up to 1.7 when decimated to a few pixels a side (57 photographs, 291 tags, noise 0, 5 and
/// 12). More is a ragged shape; half, or less, a boundary that does not close: a line or an angle.
constexpr double kMostPoints = 2.0;
constexpr double kFewestPoints = 0.55;

/// Boundary points that the contour of a convex shape with this box has when its sides are upright
/// and level: 2 (width + height) steps between pixels that share an edge, and two diagonal pairs
/// for each. Sides at 45 degrees have two thirds as many, one diagonal pair for each step.
double points_around(const Outline& o) { return 3 * 2 * (o.width() + o.height()); }

}  // namespace

Outline outline_of(std::span<const BoundaryPoint> cluster) {
  assert(!cluster.empty());
  Outline o{
      .left = cluster[0].x, .top = cluster[0].y, .right = cluster[0].x, .bottom = cluster[0].y};
  o.points = std::ssize(cluster);
  double flux = 0, normal_x = 0, normal_y = 0;
  for (const BoundaryPoint& p : cluster) {
    o.left = std::min<double>(o.left, p.x);
    o.right = std::max<double>(o.right, p.x);
    o.top = std::min<double>(o.top, p.y);
    o.bottom = std::max<double>(o.bottom, p.y);
    if (p.gx != 0 && p.gy != 0) continue;
    flux += p.x * p.gx + p.y * p.gy;
    normal_x += p.gx;
    normal_y += p.gy;
  }
  const Point center = o.center();
  o.black_area = 0.5 * (flux - center.x * normal_x - center.y * normal_y);
  return o;
}

Outline OutlineSums::outline() const {
  Outline o{.left = 0.5 * left_, .top = 0.5 * top_, .right = 0.5 * right_, .bottom = 0.5 * bottom_};
  o.points = points_;
  const Point center = o.center();
  const double flux = 0.5 * static_cast<double>(twice_flux_);
  o.black_area = 0.5 * (flux - center.x * static_cast<double>(normal_x_) -
                        center.y * static_cast<double>(normal_y_));
  return o;
}

OutlineVerdict judge_outline(const Outline& outline, const OutlineLimits& limits) {
  const double min_area = limits.min_side_px * limits.min_side_px;
  if (outline.width() * outline.height() < min_area) return OutlineVerdict::TooSmall;
  const auto points = static_cast<double>(outline.points);
  if (points > kMostPoints * points_around(outline)) return OutlineVerdict::TooManyPoints;
  if (points < kFewestPoints * points_around(outline)) return OutlineVerdict::Open;
  if (outline.reversed() ? !limits.reversed_borders : !limits.normal_borders) {
    return OutlineVerdict::WrongColour;
  }
  if (std::abs(outline.black_area) < kSmallestFilledShare * min_area) {
    return OutlineVerdict::TooSmall;
  }
  return OutlineVerdict::Promising;
}

void count_refusal(OutlineVerdict verdict, DetectStats& stats) {
  switch (verdict) {
    case OutlineVerdict::TooSmall:
      ++stats.clusters_too_small;
      break;
    case OutlineVerdict::TooManyPoints:
      ++stats.clusters_too_large;
      break;
    case OutlineVerdict::Open:
      ++stats.clusters_open;
      break;
    case OutlineVerdict::WrongColour:
      ++stats.wrong_border_colour;
      break;
    case OutlineVerdict::Promising:
      break;
  }
}

}  // namespace tagmint::detect
