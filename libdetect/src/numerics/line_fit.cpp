#include "numerics/line_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tagmint::detect {
namespace {

/// Mean and covariance of weighted points.
struct Spread {
  Point mean;
  double xx, xy, yy;  ///< covariance, px^2
};

Spread spread_of(const LineMoments& sum) {
  assert(sum.w > 0);
  const double inverse = 1 / sum.w;
  const Point mean{sum.x * inverse, sum.y * inverse};
  return {mean, sum.xx * inverse - mean.x * mean.x, sum.xy * inverse - mean.x * mean.y,
          sum.yy * inverse - mean.y * mean.y};
}

/// Smaller eigenvalue of the symmetric matrix (xx xy; xy yy), not below zero.
double smaller_eigenvalue(const Spread& s) {
  const double difference = s.xx - s.yy;
  const double root = std::sqrt(difference * difference + 4 * s.xy * s.xy);
  return std::max(0.0, 0.5 * (s.xx + s.yy - root));
}

}  // namespace

LineMoments& LineMoments::operator+=(const LineMoments& o) {
  w += o.w;
  x += o.x;
  y += o.y;
  xx += o.xx;
  xy += o.xy;
  yy += o.yy;
  return *this;
}

LineMoments operator-(const LineMoments& a, const LineMoments& b) {
  return {a.w - b.w, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}

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

LineMoments moments_between(std::span<const LineMoments> moments, int i0, int i1) {
  assert(i0 >= 0 && i0 < std::ssize(moments) && i1 >= 0 && i1 < std::ssize(moments));
  const LineMoments before = i0 > 0 ? moments[i0 - 1] : LineMoments{};
  if (i0 <= i1) return moments[i1] - before;
  return moments.back() - before + moments[i1];
}

double line_fit_mse(const LineMoments& sum) { return smaller_eigenvalue(spread_of(sum)); }

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
