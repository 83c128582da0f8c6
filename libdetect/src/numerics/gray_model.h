#pragma once

#include <optional>

#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// How bright one colour of a tag is at each place of it: gray(x, y) = cx x + cy y + c0, with (x,
/// y) in the tag plane. A plane follows light that falls off across the tag.
struct GrayPlane {
  double cx = 0;
  double cy = 0;
  double c0 = 0;

  double at(Point tag_point) const { return cx * tag_point.x + cy * tag_point.y + c0; }
};

/// Least-squares fit of a GrayPlane to samples of one colour [WangOlson2016 decode step;
/// docs/pipeline.md].
class GrayModel {
 public:
  void add(Point tag_point, double gray);
  int samples() const { return samples_; }

  /// The plane nearest to the samples; nothing when they are fewer than three or on one line.
  ///   cost     one 3 x 3 system
  std::optional<GrayPlane> fit() const;
  /// Sum of the squared distances of the samples from the plane that fit() gave, gray levels^2.
  double squared_residuals(const GrayPlane& fitted) const;

 private:
  int samples_ = 0;
  double xx_ = 0, xy_ = 0, yy_ = 0, x_ = 0, y_ = 0;  // sums of products of coordinates
  double xg_ = 0, yg_ = 0, g_ = 0, gg_ = 0;          // the same with the gray value
};

}  // namespace tagmint::detect
