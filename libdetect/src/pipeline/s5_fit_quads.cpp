#include "pipeline/s5_fit_quads.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tagmint::detect {
namespace {

/// What one pass over the unsorted points tells about a contour.
struct Outline {
  float left, top, right, bottom;  ///< edges of the smallest upright rectangle about the points
  double black_area;               ///< pixels inside; negative when they are white, not black

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Point center() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
};

/// The area is half the flux of the position through the boundary (Gauss's theorem). Pairs of
/// pixels that share an edge are the unit steps of the boundary, their gradient is its outward
/// normal where black is inside; so its sign also tells the colour. Positions count from the
/// centre, which keeps the sign right for a contour that has gaps.
Outline outline_of(std::span<const BoundaryPoint> cluster) {
  Outline o{cluster[0].x, cluster[0].y, cluster[0].x, cluster[0].y, 0};
  double flux = 0, normal_x = 0, normal_y = 0;
  for (const BoundaryPoint& p : cluster) {
    o.left = std::min(o.left, p.x);
    o.right = std::max(o.right, p.x);
    o.top = std::min(o.top, p.y);
    o.bottom = std::max(o.bottom, p.y);
    const double step = p.gx == 0 || p.gy == 0 ? 1 : 0;
    flux += step * (p.x * p.gx + p.y * p.gy);
    normal_x += step * p.gx;
    normal_y += step * p.gy;
  }
  const Point center = o.center();
  o.black_area = 0.5 * (flux - center.x * normal_x - center.y * normal_y);
  return o;
}

/// Boundary points that the contour of a convex shape with this box has when its sides are upright
/// and level: 2 (width + height) steps between pixels that share an edge, and two diagonal pairs
/// for each. Sides at 45 degrees have two thirds as many, one diagonal pair for each step.
double points_around(const Outline& o) { return 3 * 2 * (o.width() + o.height()); }

/// Bounds for the points of a cluster in units of points_around(). Tags in photographs have 0.69 to
/// 1.08, up to 1.7 when decimated to a few pixels a side (57 photographs, 291 tags, noise 0, 5 and
/// 12). More is a ragged shape; half, or less, a boundary that does not close: a line or an angle.
constexpr double kMostPoints = 2.0;
constexpr double kFewestPoints = 0.55;

/// Bounds for the pixels inside a contour as a share of the area of its quad. Squares of 5 to 20 px
/// in any position, with noise of 0 and 15 levels, have 0.97 to 1.07, tags in photographs 0.99 to
/// 1.02 and 0.6 to 1.2 when decimated to their last legible pixels. Quads fitted to noise have any.
constexpr double kSmallestShare = 0.6;
constexpr double kLargestShare = 1.3;

/// A number in [0, 4] that grows with the angle of (x, y) as seen, counter-clockwise from the right
/// (y down), without a trigonometric function: the place where the ray meets |x| + |y| = 1.
float diamond_angle(float x, float y) {
  const float sum = std::abs(x) + std::abs(y);
  if (sum == 0) return 0;
  const float along = x / sum;
  return y > 0 ? 3 + along : 1 - along;
}

/// Magnitude of the gradient at a boundary point, gray levels a pixel, from the four pixels
/// diagonally about it, so that no side of the edge is preferred: for a coordinate half-way between
/// two pixels those two, for one in the middle of a pixel its two neighbours. Beyond the image its
/// edge pixels go on.
double gradient_magnitude(ImageView image, const BoundaryPoint& p) {
  const int twice_x = static_cast<int>(2 * p.x), twice_y = static_cast<int>(2 * p.y);
  const int left = twice_x / 2 - 1, right = (twice_x + 1) / 2;
  const int top = twice_y / 2 - 1, bottom = (twice_y + 1) / 2;
  const int x0 = std::max(left, 0), x1 = std::min(right, image.width - 1);
  const std::uint8_t* above = image.row(std::max(top, 0));
  const std::uint8_t* below = image.row(std::min(bottom, image.height - 1));
  const int rightward = above[x1] + below[x1] - above[x0] - below[x0];
  const int downward = below[x0] + below[x1] - above[x0] - above[x1];
  // Twice the gradient: each is a sum of two differences. Pixels two apart count half.
  const double gx = right - left == 1 ? rightward : 0.5 * rightward;
  const double gy = bottom - top == 1 ? downward : 0.5 * downward;
  return 0.5 * std::sqrt(gx * gx + gy * gy);
}

/// Orders the points by angle about `center`, leaves out repetitions (the two diagonals of four
/// pixels have one midpoint), and weights them. Points are relative to the centre.
void sort_points(std::span<const BoundaryPoint> cluster, ImageView working, Point center,
                 QuadScratch& s) {
  const auto center_x = static_cast<float>(center.x), center_y = static_cast<float>(center.y);
  constexpr float kAngleSteps = 1 << 29;  // 4 * 2^29 fits in 32 bits
  s.order.resize(cluster.size());
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    const float angle = diamond_angle(cluster[i].x - center_x, cluster[i].y - center_y);
    s.order[i] = std::uint64_t{static_cast<std::uint32_t>(angle * kAngleSteps)} << 32 | i;
  }
  std::sort(s.order.begin(), s.order.end());
  s.points.clear();
  s.weights.clear();
  for (const std::uint64_t packed : s.order) {
    const BoundaryPoint& p = cluster[packed & 0xffffffff];
    const Point relative{p.x - center.x, p.y - center.y};
    if (!s.points.empty() && s.points.back() == relative) continue;
    s.points.push_back(relative);
    // One gray level more, so that no point is without weight.
    s.weights.push_back(gradient_magnitude(working, p) + 1);
  }
}

/// Whether the quad is convex, runs counter-clockwise as seen, is large enough, and its corners are
/// not nearly straight or folded.
bool has_shape_of_tag(const Corners& corners, double min_area, double max_cosine) {
  if (-signed_area(corners) < min_area) return false;
  for (int i = 0; i < 4; ++i) {
    const Point in = corners[(i + 1) % 4] - corners[i];
    const Point out = corners[(i + 2) % 4] - corners[(i + 1) % 4];
    if (cross(in, out) >= 0) return false;
    if (std::abs(dot(in, out)) > max_cosine * length(in) * length(out)) return false;
  }
  return true;
}

std::optional<Corners> meet(const std::array<LineFit, 4>& sides, Point center) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Point> corner = intersect(sides[(i + 3) % 4], sides[i]);
    if (!corner) return std::nullopt;
    corners[i] = *corner + center;
  }
  return corners;
}

}  // namespace

std::optional<Quad> fit_quad(std::span<const BoundaryPoint> cluster, ImageView working,
                             const QuadOptions& options, QuadScratch& scratch, DetectStats& stats) {
  const auto refuse = [](std::int64_t& counter) {
    ++counter;
    return std::nullopt;
  };
  if (cluster.empty()) return refuse(stats.clusters_too_small);
  const auto count = static_cast<double>(cluster.size());
  const double min_area = options.min_side_px * options.min_side_px;
  const Outline outline = outline_of(cluster);
  if (outline.width() * outline.height() < min_area) return refuse(stats.clusters_too_small);
  if (count > kMostPoints * points_around(outline)) return refuse(stats.clusters_too_large);
  if (count < kFewestPoints * points_around(outline)) return refuse(stats.clusters_open);
  const bool reversed = outline.black_area < 0;
  if (reversed ? !options.reversed_borders : !options.normal_borders) {
    return refuse(stats.wrong_border_colour);
  }
  const double area = std::abs(outline.black_area);
  if (area < kSmallestShare * min_area) return refuse(stats.clusters_too_small);

  const Point center = outline.center();
  sort_points(cluster, working, center, scratch);
  line_moments(scratch.points, scratch.weights, scratch.moments);
  const std::span<const int> candidates =
      find_corner_candidates(scratch.moments, options.max_corner_candidates, scratch.corners);
  if (candidates.size() < 4) return refuse(stats.no_corners);

  const double max_cosine = std::cos(options.critical_angle_deg * std::numbers::pi / 180);
  const auto best = choose_corners(scratch.moments, candidates,
                                   {options.max_line_fit_mse_px2, max_cosine}, scratch.corners);
  if (!best) return refuse(stats.bad_fit);
  const std::optional<Corners> corners = meet(best->sides, center);
  if (!corners || !has_shape_of_tag(*corners, min_area, max_cosine)) {
    return refuse(stats.bad_shape);
  }
  const double share = area / -signed_area(*corners);
  if (share < kSmallestShare || share > kLargestShare) return refuse(stats.bad_shape);
  ++stats.quads;
  return Quad{*corners, reversed};
}

}  // namespace tagmint::detect
