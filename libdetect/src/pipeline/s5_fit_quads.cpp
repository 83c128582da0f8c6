#include "pipeline/s5_fit_quads.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/outline.h"

namespace tagmint::detect {
namespace {

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
  const Outline outline = outline_of(cluster);
  const OutlineVerdict verdict = judge_outline(
      outline, {options.min_side_px, options.normal_borders, options.reversed_borders});
  if (verdict != OutlineVerdict::Promising) {
    count_refusal(verdict, stats);
    return std::nullopt;
  }

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
  if (!corners ||
      !has_shape_of_tag(*corners, options.min_side_px * options.min_side_px, max_cosine)) {
    return refuse(stats.bad_shape);
  }
  const double share = std::abs(outline.black_area) / -signed_area(*corners);
  if (share < kSmallestFilledShare || share > kLargestFilledShare) return refuse(stats.bad_shape);
  ++stats.quads;
  return Quad{*corners, outline.reversed()};
}

}  // namespace tagmint::detect
