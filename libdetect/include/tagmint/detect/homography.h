#pragma once

#include <array>
#include <optional>

#include "tagmint/codec/export.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// A projective map of the plane, row-major 3 x 3. Maps tag to image unless named otherwise: the
/// border square is [-1,1]^2 with y down, the image is in pixels.
class TAGMINT_API Homography {
 public:
  Homography() : h_{1, 0, 0, 0, 1, 0, 0, 0, 1} {}
  explicit Homography(const std::array<double, 9>& row_major) : h_(row_major) {}

  /// The map that takes from[i] to to[i], scaled so that h22 = 1 where the origin has a finite
  /// image; nothing when three of the points lie on a line.
  ///   cost     a few 3 x 3 products: both point sets as images of one projective frame
  static std::optional<Homography> from_points(const std::array<Point, 4>& from,
                                               const std::array<Point, 4>& to);
  /// The map that takes kTagCorners to `corners`.
  static std::optional<Homography> from_corners(const Corners& corners);

  /// Image of p. On the line at infinity the result has infinite or NaN coordinates.
  Point project(Point p) const;
  std::optional<Homography> inverse() const;
  /// The map that turns the tag plane by `turns` quarter turns first, clockwise as seen:
  /// rotated(1).project({x, y}) = project({-y, x}). Any integer, taken modulo 4.
  Homography rotated(int turns) const;

  const std::array<double, 9>& row_major() const { return h_; }
  double operator()(int row, int column) const { return h_[row * 3 + column]; }
  friend bool operator==(const Homography&, const Homography&) = default;

 private:
  std::array<double, 9> h_;
};

}  // namespace tagmint::detect
