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
/// Points that a side needs for its line to be that of their means.
constexpr int kMinMeanPoints = 6;
/// The meeting of two such lines is a corner if the sine of their angle is at least this, and if it
/// is this near to the extreme point: px, and a share of the shorter half side.
constexpr double kMinCornerSine = 0.1;
constexpr double kMaxShiftPx = 2.5;
constexpr double kMaxShiftShare = 0.15;
/// Shapes of at least this mean side whose area is right to this share may have points far from
/// their sides.
constexpr double kMarkedSidePx = 24;
constexpr double kMarkedAreaShare = 0.06;
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

/// Moves each corner to the point farthest outside the line through its neighbours. Where a side is
/// parallel to a line that a corner was taken farthest from, any point of the side may have been.
FourPoints moved_outwards(const Outline& o, FourPoints corners) {
  for (std::size_t i = 0; i < 4; ++i) {
    // The outline runs clockwise: its outside is on the left of a step backwards.
    corners[i] = beside_line(o, corners[(i + 3) % 4], corners[(i + 1) % 4]).left;
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

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
    std::sort(corners.begin(), corners.end());
    corners = moved_outwards(o, corners);
  }
  std::sort(corners.begin(), corners.end());
  if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) return std::nullopt;
  return corners;
}

/// A side's line, through two places far from each other. Relative to the outline's origin.
struct SideLine {
  Point from;
  Point to;
};

/// Mean of `count` points of the outline from `first` on, which may wrap.
Point mean_point(const Outline& o, int first, int count) {
  Point sum;
  for (int i = 0; i < count; ++i) {
    const int k = first + i < o.size() ? first + i : first + i - o.size();
    sum = sum + Point{o.x(k), o.y(k)};
  }
  return (1.0 / count) * sum;
}

/// The line between two corners: through the means of the points of its first and its second half,
/// where it has enough of them (a level side has hardly any). Corners are rounded by blur, or end
/// in a speck, so the points next to them stay out.
SideLine line_between(const Outline& o, int begin, int end) {
  const int points = (end - begin + o.size()) % o.size();
  if (points < kMinMeanPoints) {
    return {{o.x(begin), o.y(begin)}, {o.x(end), o.y(end)}};
  }
  const int margin = 1 + points / 8;
  const int half = (points - 2 * margin) / 2;
  const auto wrapped = [&](int i) { return i < o.size() ? i : i - o.size(); };
  return {mean_point(o, wrapped(begin + margin), half),
          mean_point(o, wrapped(begin + margin + half), half)};
}

/// Where two sides meet, if that is near the extreme point that parts them; else that point.
Point corner_of(const SideLine& before, const SideLine& after, Point extreme) {
  const Point u = before.to - before.from;
  const Point v = after.to - after.from;
  const double area = cross(u, v);
  if (std::abs(area) < kMinCornerSine * std::sqrt(dot(u, u) * dot(v, v))) return extreme;
  const Point meeting = before.from + (cross(after.from - before.from, v) / area) * u;
  const Point shift = meeting - extreme;
  const double most = kMaxShiftPx + kMaxShiftShare * std::sqrt(std::min(dot(u, u), dot(v, v)));
  return dot(shift, shift) <= most * most ? meeting : extreme;
}

/// Whether the points between two corners are near the line between the corners' places, but for
/// those next to an extreme point: the corner may be on either side of it. Relative to the
/// outline's origin.
bool is_straight(const Outline& o, int begin, int end, Point from, Point to) {
  const auto ax = static_cast<float>(from.x);
  const auto ay = static_cast<float>(from.y);
  const auto ex = static_cast<float>(to.x - from.x);
  const auto ey = static_cast<float>(to.y - from.y);
  const float length = length_of(ex, ey);
  const float most = length * (kMaxDeviationPx + kMaxDeviationShare * length);
  const auto near = [&](int first, int count) {
    return count <= 0 || all_near_line(o.part(first, count), ax, ay, ex, ey, most);
  };
  const int points = (end - begin + o.size()) % o.size();
  const int margin = 1 + points / 8;
  const int first = begin + margin;
  const int last = begin + points - margin;  // one behind
  return near(first, std::min(last, o.size()) - first) &&
         near(std::max(first, o.size()) - o.size(), last - std::max(first, o.size()));
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
  // The outline runs clockwise.
  std::array<SideLine, 4> lines;  // from corner i to the next one
  for (std::size_t i = 0; i < 4; ++i) {
    lines[i] = line_between(outline, (*points)[i], (*points)[(i + 1) % 4]);
  }
  Corners clockwise;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t before = (i + 3) % 4;
    const Point extreme =
        outline.corner_near((*points)[i], (*points)[before], (*points)[(i + 1) % 4]);
    clockwise[i] = corner_of(lines[before], lines[i], extreme);
  }
  const double off = std::abs(signed_area(clockwise) - area);
  if (off > kAreaShare * area + kAreaPerPoint * 2 * shape.height) {
    return {{}, CornerOutcome::WrongArea};
  }
  // Specks and pens' marks stick out of a border by up to a cell. They hardly change its area, and
  // the gray values of T6 tell a large border from other shapes well enough.
  const bool marked = area >= kMarkedSidePx * kMarkedSidePx && off <= kMarkedAreaShare * area;
  for (std::size_t i = 0; i < 4 && !marked; ++i) {
    if (!is_straight(outline, (*points)[i], (*points)[(i + 1) % 4], clockwise[i],
                     clockwise[(i + 1) % 4])) {
      return {{}, CornerOutcome::NotStraight};
    }
  }
  Corners corners;
  const Point origin{static_cast<double>(shape.left_most), static_cast<double>(shape.top)};
  for (std::size_t i = 0; i < 4; ++i) corners[3 - i] = clockwise[i] + origin;
  return {corners, {}};
}

}  // namespace tagmint::detect
