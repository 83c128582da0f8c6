#include "pipeline/s5_fit_quads.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tagmint::detect {
namespace {

/// Edges of the smallest upright rectangle about the points.
struct Box {
  float left, top, right, bottom;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Point center() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
};

Box box_about(std::span<const BoundaryPoint> cluster) {
  Box box{cluster[0].x, cluster[0].y, cluster[0].x, cluster[0].y};
  for (const BoundaryPoint& p : cluster) {
    box.left = std::min(box.left, p.x);
    box.right = std::max(box.right, p.x);
    box.top = std::min(box.top, p.y);
    box.bottom = std::max(box.bottom, p.y);
  }
  return box;
}

/// Most boundary points that a contour of a convex shape with this box has: 2 (width + height)
/// steps between pixels that share an edge, and two diagonal pairs for each.
double most_convex_points(double width, double height) { return 3 * 2 * (width + height); }

/// Noise makes an edge ragged, and so longer; a tag's contour stays below twice the convex one.
constexpr double kRaggedness = 2.0;

/// Positive when the gradients, which point to white, point away from the centre: black inside.
double outward_gradient(std::span<const BoundaryPoint> cluster, Point center) {
  double sum = 0;
  for (const BoundaryPoint& p : cluster) {
    sum += (p.x - center.x) * p.gx + (p.y - center.y) * p.gy;
  }
  return sum;
}

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
  const int left = static_cast<int>(std::floor(p.x)) - 1, right = static_cast<int>(std::ceil(p.x));
  const int top = static_cast<int>(std::floor(p.y)) - 1, bottom = static_cast<int>(std::ceil(p.y));
  const int x0 = std::max(left, 0), x1 = std::min(right, image.width - 1);
  const std::uint8_t* above = image.row(std::max(top, 0));
  const std::uint8_t* below = image.row(std::min(bottom, image.height - 1));
  const double gx = 0.5 * (above[x1] + below[x1] - above[x0] - below[x0]) / (right - left);
  const double gy = 0.5 * (below[x0] + below[x1] - above[x0] - above[x1]) / (bottom - top);
  return std::sqrt(gx * gx + gy * gy);
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
  const Box box = box_about(cluster);
  if (box.width() * box.height() < min_area) return refuse(stats.clusters_too_small);
  if (count > most_convex_points(working.width, working.height) ||
      count > kRaggedness * most_convex_points(box.width(), box.height())) {
    return refuse(stats.clusters_too_large);
  }
  const Point center = box.center();
  const bool reversed = outward_gradient(cluster, center) < 0;
  if (reversed ? !options.reversed_borders : !options.normal_borders) {
    return refuse(stats.wrong_border_colour);
  }

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
  ++stats.quads;
  return Quad{*corners, reversed};
}

}  // namespace tagmint::detect
