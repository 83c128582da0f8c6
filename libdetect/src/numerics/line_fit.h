#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// Weighted sums over boundary points: w, w x, w y, w x^2, w x y, w y^2.
struct LineMoments {
  double w = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  double yy = 0;

  LineMoments& operator+=(const LineMoments& o) {
    w += o.w;
    x += o.x;
    y += o.y;
    xx += o.xx;
    xy += o.xy;
    yy += o.yy;
    return *this;
  }
  friend LineMoments operator+(LineMoments a, const LineMoments& b) { return a += b; }
  friend LineMoments operator-(const LineMoments& a, const LineMoments& b) {
    return {a.w - b.w, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
  }
};

/// A line through `centroid` with unit `normal`; which of the two normals is not specified.
struct LineFit {
  Point centroid;
  Point normal;
  double mse = 0;  ///< weighted mean squared distance of the points from the line, px^2
};

/// Prefix sums: moments[i] is the sum over points 0 .. i.
///   points, weights   n each, coordinates in px (small numbers about their centre keep the sums
///                     exact), weights > 0
///   moments           takes the n sums
void line_moments(std::span<const Point> points, std::span<const double> weights,
                  std::vector<LineMoments>& moments);

/// Sum over points i0 .. i1 (both included) of a closed contour, wrapping past the end when i1 <
/// i0.
///   moments   from line_moments(); i0 and i1 are indices in [0, n)
///   cost      O(1)
inline LineMoments moments_between(std::span<const LineMoments> moments, int i0, int i1) {
  assert(i0 >= 0 && i0 < std::ssize(moments) && i1 >= 0 && i1 < std::ssize(moments));
  const LineMoments before = i0 > 0 ? moments[i0 - 1] : LineMoments{};
  if (i0 <= i1) return moments[i1] - before;
  return moments.back() - before + moments[i1];
}

namespace line_fit {

/// Mean and covariance of weighted points.
struct Spread {
  Point mean;
  double xx, xy, yy;  ///< covariance, px^2
};

inline Spread spread_of(const LineMoments& sum) {
  assert(sum.w > 0);
  const double inverse = 1 / sum.w;
  const Point mean{sum.x * inverse, sum.y * inverse};
  return {mean, sum.xx * inverse - mean.x * mean.x, sum.xy * inverse - mean.x * mean.y,
          sum.yy * inverse - mean.y * mean.y};
}

/// Smaller eigenvalue of the symmetric matrix (xx xy; xy yy), not below zero.
inline double smaller_eigenvalue(const Spread& s) {
  const double difference = s.xx - s.yy;
  const double root = std::sqrt(difference * difference + 4 * s.xy * s.xy);
  return std::max(0.0, 0.5 * (s.xx + s.yy - root));
}

}  // namespace line_fit

/// The line that fits points of the given sums best: principal component of their covariance.
///   mse      the smaller eigenvalue of the 2x2 covariance
///   source   [WangOlson2016, section III-D]; normal from the 2x2 eigenproblem, docs/pipeline.md
LineFit fit_line(const LineMoments& sum);

/// mse of fit_line() alone, which needs no normal.
inline double line_fit_mse(const LineMoments& sum) {
  return line_fit::smaller_eigenvalue(line_fit::spread_of(sum));
}

/// Where the two lines meet; nothing when the sine of the angle between them is below
/// `parallel_sine`.
std::optional<Point> intersect(const LineFit& a, const LineFit& b, double parallel_sine = 1e-6);

}  // namespace tagmint::detect
