#include "tagmint/detect/homography.h"

#include <algorithm>
#include <cmath>

#include "numerics/small_matrix.h"

namespace tagmint::detect {
namespace {

/// Three points count as on one line when twice their triangle's area is below this share of the
/// square of the points' extent.
constexpr double kCollinear = 1e-12;

double extent(const std::array<Point, 4>& points) {
  double farthest = 0;
  for (const Point p : points) farthest = std::max(farthest, length(p - points[0]));
  return farthest;
}

/// The map that takes the projective frame (1,0,0) (0,1,0) (0,0,1) (1,1,1) to four points: columns
/// are the first three, weighted so that their sum is the fourth. By Cramer's rule the weights are
/// areas of triangles.
std::optional<Matrix3> from_frame(const std::array<Point, 4>& p) {
  const double least_area = kCollinear * extent(p) * extent(p);
  const double whole = cross(p[1] - p[0], p[2] - p[0]);
  const std::array<double, 3> part = {cross(p[1] - p[3], p[2] - p[3]),
                                      cross(p[2] - p[3], p[0] - p[3]),
                                      cross(p[0] - p[3], p[1] - p[3])};
  if (!(std::abs(whole) > least_area)) return std::nullopt;
  Matrix3 frame{};
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(part[i]) > least_area)) return std::nullopt;
    const double weight = part[i] / whole;
    frame[i] = weight * p[i].x;
    frame[3 + i] = weight * p[i].y;
    frame[6 + i] = weight;
  }
  return frame;
}

Point middle(const std::array<Point, 4>& p) { return 0.25 * (p[0] + p[1] + p[2] + p[3]); }

std::array<Point, 4> moved(std::array<Point, 4> points, Point by) {
  for (Point& p : points) p = p - by;
  return points;
}

Matrix3 translation(Point by) { return {1, 0, by.x, 0, 1, by.y, 0, 0, 1}; }

}  // namespace

std::optional<Homography> Homography::from_points(const std::array<Point, 4>& from,
                                                  const std::array<Point, 4>& to) {
  // Both sets are moved to their middle first: far from the origin, products of large coordinates
  // would cost digits.
  const Point from_middle = middle(from);
  const Point to_middle = middle(to);
  const std::optional<Matrix3> from_map = from_frame(moved(from, from_middle));
  const std::optional<Matrix3> to_map = from_frame(moved(to, to_middle));
  if (!from_map || !to_map) return std::nullopt;
  Matrix3 h = multiply(*to_map, adjugate(*from_map));
  h = multiply(translation(to_middle), multiply(h, translation(-1.0 * from_middle)));
  // The scale is free. Where the origin has a finite image, h22 = 1 is the usual choice.
  double largest = 0;
  for (const double value : h) largest = std::max(largest, std::abs(value));
  const double scale = std::abs(h[8]) > 1e-12 * largest ? h[8] : largest;
  for (double& value : h) value /= scale;
  return Homography(h);
}

std::optional<Homography> Homography::from_corners(const Corners& corners) {
  return from_points(kTagCorners, corners);
}

Point Homography::project(Point p) const {
  const double w = h_[6] * p.x + h_[7] * p.y + h_[8];
  return {(h_[0] * p.x + h_[1] * p.y + h_[2]) / w, (h_[3] * p.x + h_[4] * p.y + h_[5]) / w};
}

std::optional<Homography> Homography::inverse() const {
  const std::optional<Matrix3> inverted = detect::inverse(h_);
  if (!inverted) return std::nullopt;
  return Homography(*inverted);
}

Homography Homography::rotated(int turns) const {
  // A quarter turn clockwise as seen takes (x, y) to (-y, x), so the first column of the turned map
  // is the second of the old one, and the second the negated first.
  Matrix3 h = h_;
  for (int turn = 0; turn < (turns & 3); ++turn) {
    for (int row = 0; row < 9; row += 3) {
      const double first = h[row];
      h[row] = h[row + 1];
      h[row + 1] = -first;
    }
  }
  return Homography(h);
}

}  // namespace tagmint::detect
