#include "numerics/line_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tagmint::detect {
namespace {

using line_fit::smaller_eigenvalue;
using line_fit::Spread;
using line_fit::spread_of;

}  // namespace

void line_moments(std::span<const Point> points, std::span<const double> weights,
                  std::vector<LineMoments>& moments) {
  assert(points.size() == weights.size());
  moments.resize(points.size());
  LineMoments sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    const double w = weights[i];
    sum += {w, w * p.x, w * p.y, w * p.x * p.x, w * p.x * p.y, w * p.y * p.y};
    moments[i] = sum;
  }
}

LineFit fit_line(const LineMoments& sum) {
  const Spread s = spread_of(sum);
  const double eigenvalue = smaller_eigenvalue(s);
  // (C - eigenvalue) normal = 0: both rows give the normal; the longer answer is the exact one.
  const Point from_first{s.xy, eigenvalue - s.xx};
  const Point from_second{eigenvalue - s.yy, s.xy};
  const double first = dot(from_first, from_first), second = dot(from_second, from_second);
  const double squared = std::max(first, second);
  if (squared == 0) return {s.mean, {1, 0}, eigenvalue};  // a round heap: every direction fits
  return {s.mean, (1 / std::sqrt(squared)) * (first > second ? from_first : from_second),
          eigenvalue};
}

std::optional<Point> intersect(const LineFit& a, const LineFit& b, double parallel_sine) {
  // n_a . p = n_a . c_a and n_b . p = n_b . c_b, by Cramer's rule.
  const double sine = cross(a.normal, b.normal);
  if (std::abs(sine) < parallel_sine) return std::nullopt;
  const double offset_a = dot(a.normal, a.centroid), offset_b = dot(b.normal, b.centroid);
  return Point{(offset_a * b.normal.y - offset_b * a.normal.y) / sine,
               (offset_b * a.normal.x - offset_a * b.normal.x) / sine};
}

}  // namespace tagmint::detect
