#include "tracker/t5_corners.h"

#include <algorithm>
#include <cmath>

namespace tagmint::detect {
namespace {

/// A shape fills at least this share of its box: even a quad on the box's diagonal does.
constexpr double kMinBoxShare = 0.1;
/// Corners lie at least this far from the line through their neighbours: a share of its length, and
/// px.
constexpr float kMinCornerShare = 0.04f;
constexpr float kMinCornerPx = 1.6f;
/// The area of the corners' quad may differ from the shape's by this share, and by this many px^2
/// for each point of the outline (each is off by up to half a pixel).
constexpr double kAreaShare = 0.10;
constexpr double kAreaPerPoint = 0.25;
/// Points of the outline may lie this far from their side: px, and a share of its length, since a
/// corner's extreme point may be at the other end of a nearly level run than the corner, and lenses
/// bend long sides.
constexpr float kMaxDeviationPx = 1.7f;
constexpr float kMaxDeviationShare = 0.03f;

/// Builds the outline clockwise as seen: down the right side, up the left one. Coordinates relative
/// to (left_most, top), so that they are exact as floats.
class Outline {
 public:
  Outline(const Shape& shape, OutlineScratch& scratch)
      : shape_(shape), step_((shape.height + kMaxOutlineRows - 1) / kMaxOutlineRows) {
    rows_ = (shape.height - 1) / step_ + 1;
    const auto padded = static_cast<std::size_t>(2 * rows_ + 1 + kOutlinePadding);
    if (scratch.x.size() < padded) {
      scratch.x.resize(padded);
      scratch.y.resize(padded);
    }
    x_ = scratch.x.data();
    y_ = scratch.y.data();
    for (int i = 0; i < rows_; ++i) {
      const int row = row_of(i);
      x_[i] = static_cast<float>(shape.right[row] + 1 - shape.left_most);
      y_[i] = height_of(row);
      const int mirrored = 2 * rows_ - 1 - i;
      x_[mirrored] = static_cast<float>(shape.left[row] - shape.left_most);
      y_[mirrored] = height_of(row);
    }
    std::fill_n(x_ + 2 * rows_, kOutlinePadding, x_[2 * rows_ - 1]);
    std::fill_n(y_ + 2 * rows_, kOutlinePadding, y_[2 * rows_ - 1]);
  }

  int size() const { return 2 * rows_; }
  OutlineView view() const { return {x_, y_, size()}; }
  OutlineView part(int first, int count) const { return {x_ + first, y_ + first, count}; }
  float x(int i) const { return x_[i]; }
  float y(int i) const { return y_[i]; }

  /// Where rows were left out: the point between i's neighbours that is farthest from the line
  /// through `before` and `after`. Relative to the outline's origin.
  Point corner_near(int i, int before, int after) const {
    const Point from{x_[before], y_[before]};
    const Point along = Point{x_[after], y_[after]} - from;
    Point best{x_[i], y_[i]};
    if (step_ == 1) return best;
    const bool right_side = i < rows_;
    const int middle = row_of(right_side ? i : 2 * rows_ - 1 - i);
    double largest = std::abs(cross(along, best - from));
    for (int row = std::max(0, middle - step_); row <= std::min(shape_.height - 1, middle + step_);
         ++row) {
      const int edge = right_side ? shape_.right[row] + 1 : shape_.left[row];
      const Point p{static_cast<double>(edge - shape_.left_most), height_of(row)};
      const double distance = std::abs(cross(along, p - from));
      if (distance > largest) {
        largest = distance;
        best = p;
      }
    }
    return best;
  }

 private:
  /// The last row is always there.
  int row_of(int i) const { return i + 1 == rows_ ? shape_.height - 1 : i * step_; }
  /// Rows count at their middle, the first and the last at the shape's ends.
  float height_of(int row) const {
    if (row == 0) return 0;
    if (row == shape_.height - 1) return static_cast<float>(shape_.height);
    return static_cast<float>(row) + 0.5f;
  }

  const Shape& shape_;
  int step_;
  int rows_;
  float* x_;
  float* y_;
};

/// Coordinates are far from any overflow of their squares.
float length_of(float x, float y) { return std::sqrt(x * x + y * y); }

float distance_between(const Outline& o, int i, int k) {
  return length_of(o.x(k) - o.x(i), o.y(k) - o.y(i));
}

/// Points farthest on both sides of the line from i to k; distances in px.
FarthestBothSides beside_line(const Outline& o, int i, int k) {
  const float length = distance_between(o, i, k);
  if (!(length > 0)) return {};
  const float scale = 1 / length;
  return farthest_both_sides(o.view(), o.x(i), o.y(i), scale * (o.x(k) - o.x(i)),
                             scale * (o.y(k) - o.y(i)));
}

using FourPoints = std::array<int, 4>;

/// Indices of four corners in the outline's order; nothing where it has none.
std::optional<FourPoints> extreme_points(const Outline& o, float middle_x, float middle_y) {
  const int first = farthest_point(o.view(), middle_x, middle_y);
  const int second = farthest_point(o.view(), o.x(first), o.y(first));
  const float least = std::max(kMinCornerPx, kMinCornerShare * distance_between(o, first, second));
  const FarthestBothSides sides = beside_line(o, first, second);
  const bool right = sides.right_distance > least;
  const bool left = sides.left_distance > least;
  FourPoints corners{first, second, sides.right, sides.left};
  if (!right && !left) return std::nullopt;
  if (!right || !left) {
    // Both are on one side: first and second are neighbours, and the fourth corner lies outside one
    // of the other sides of the triangle.
    const int third = right ? sides.right : sides.left;
    const FarthestBothSides a = beside_line(o, first, third);
    const FarthestBothSides b = beside_line(o, third, second);
    const float beyond_a = right ? a.right_distance : a.left_distance;
    const float beyond_b = right ? b.right_distance : b.left_distance;
    if (std::max(beyond_a, beyond_b) <= least) return std::nullopt;
    const FarthestBothSides& farther = beyond_a > beyond_b ? a : b;
    corners = {first, second, third, right ? farther.right : farther.left};
  }
  std::sort(corners.begin(), corners.end());
  if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) return std::nullopt;
  return corners;
}

/// Whether all points between two corners are near the line through them.
bool is_straight(const Outline& o, int begin, int end) {
  const float ex = o.x(end) - o.x(begin);
  const float ey = o.y(end) - o.y(begin);
  const float length = length_of(ex, ey);
  const float most = length * (kMaxDeviationPx + kMaxDeviationShare * length);
  const auto near = [&](int first, int count) {
    return all_near_line(o.part(first, count), o.x(begin), o.y(begin), ex, ey, most);
  };
  if (begin < end) return near(begin, end - begin);
  return near(begin, o.size() - begin) && (end == 0 || near(0, end));
}

}  // namespace

CornerResult find_corners(const Shape& shape, const CornerOptions& options,
                          OutlineScratch& scratch) {
  const int width = shape.right_most - shape.left_most + 1;
  const auto area = static_cast<double>(shape.area);
  if (std::min(width, shape.height) < kStartDepth ||
      area < options.min_side_px * options.min_side_px ||
      area < kMinBoxShare * width * shape.height) {
    return {{}, CornerOutcome::TooSmall};
  }
  const Outline outline(shape, scratch);
  const std::optional<FourPoints> points = extreme_points(outline, 0.5f * static_cast<float>(width),
                                                          0.5f * static_cast<float>(shape.height));
  if (!points) return {{}, CornerOutcome::NoCorners};
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    // The outline runs clockwise.
    const Point at =
        outline.corner_near((*points)[i], (*points)[(i + 3) % 4], (*points)[(i + 1) % 4]);
    corners[3 - i] =
        at + Point{static_cast<double>(shape.left_most), static_cast<double>(shape.top)};
  }
  const double off = std::abs(-signed_area(corners) - area);
  if (off > kAreaShare * area + kAreaPerPoint * 2 * shape.height) {
    return {{}, CornerOutcome::WrongArea};
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (!is_straight(outline, (*points)[i], (*points)[(i + 1) % 4])) {
      return {{}, CornerOutcome::NotStraight};
    }
  }
  return {corners, {}};
}

}  // namespace tagmint::detect
