#include "scene/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tagmint::scene {

using detect::Corners;
using detect::Homography;
using detect::Point;

namespace {

/// Columns: the tag's x axis and y axis over half an edge, and its middle; in camera coordinates.
std::array<double, 9> plane_in_camera(const PosedTag& tag) {
  std::array<double, 9> plane{};
  for (std::size_t row = 0; row < 3; ++row) {
    plane[row * 3] = tag.pose.R[row * 3] * tag.edge_m / 2;
    plane[row * 3 + 1] = tag.pose.R[row * 3 + 1] * tag.edge_m / 2;
    plane[row * 3 + 2] = tag.pose.t[row];
  }
  return plane;
}

/// K * plane, for the camera matrix K of a camera without distortion.
std::array<double, 9> to_pixels(const std::array<double, 9>& plane, const detect::Camera& camera) {
  std::array<double, 9> pixels = plane;
  for (std::size_t column = 0; column < 3; ++column) {
    pixels[column] = camera.fx * plane[column] + camera.cx * plane[6 + column];
    pixels[3 + column] = camera.fy * plane[3 + column] + camera.cy * plane[6 + column];
  }
  return pixels;
}

Point middle(Point a, Point b) { return 0.5 * (a + b); }

/// Distance of p from the line through a and b.
double distance_from_chord(Point p, Point a, Point b) {
  const double chord = length(b - a);
  return chord > 0 ? std::abs(cross(b - a, p - a)) / chord : length(p - a);
}

}  // namespace

TagProjection::TagProjection(const TagPlace& place, const detect::Camera& camera) {
  if (const auto* posed = std::get_if<PosedTag>(&place)) {
    plane_ = plane_in_camera(*posed);
    if (camera.distorts()) {
      camera_ = camera;
    } else {
      plane_ = to_pixels(plane_, camera);
    }
  } else {
    const auto homography = Homography::from_corners(std::get<Corners>(place));
    plane_ = homography ? homography->row_major() : std::array<double, 9>{};
  }
  // The middle gets depth 1; the sign of a pose's depth is kept, as it tells front from behind.
  const bool posed = std::holds_alternative<PosedTag>(place);
  const double scale = posed ? std::abs(plane_[8]) : plane_[8];
  if (scale != 0) {
    for (double& h : plane_) h /= scale;
  }
}

double TagProjection::depth(Point p) const { return plane_[6] * p.x + plane_[7] * p.y + plane_[8]; }

Point TagProjection::project(Point p) const {
  const double w = depth(p);
  const Point q{(plane_[0] * p.x + plane_[1] * p.y + plane_[2]) / w,
                (plane_[3] * p.x + plane_[4] * p.y + plane_[5]) / w};
  return camera_ ? camera_->to_pixel(q) : q;
}

Corners TagProjection::corners() const {
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = project(detect::kTagCorners[i]);
  return corners;
}

std::optional<Homography> TagProjection::homography() const {
  if (curved()) return Homography::from_corners(corners());
  std::array<double, 9> h = plane_;
  if (h[8] == 0) return std::nullopt;
  for (double& value : h) value /= plane_[8];
  return Homography(h);
}

void TagProjection::trace(Point a, Point b, std::vector<Point>& out) const {
  const Point start = project(a);
  out.push_back(start);
  if (!curved()) return;
  // Halve while the middle of a piece is off its chord. A short first look could miss an S-shaped
  // piece whose middle is on the chord, so a segment is cut in four at least.
  struct Piece {
    Point a, b, a_px, b_px;
    int level;
  };
  std::vector<Piece> todo = {{a, b, start, project(b), 0}};
  constexpr int kLeastLevel = 2;
  constexpr int kMostLevel = 14;
  while (!todo.empty()) {
    const Piece piece = todo.back();
    todo.pop_back();
    const Point m = middle(piece.a, piece.b);
    const Point m_px = project(m);
    const bool flat = distance_from_chord(m_px, piece.a_px, piece.b_px) < kChordError_px;
    if ((flat && piece.level >= kLeastLevel) || piece.level >= kMostLevel) {
      out.push_back(piece.b_px);
      continue;
    }
    todo.push_back({m, piece.b, m_px, piece.b_px, piece.level + 1});
    todo.push_back({piece.a, m, piece.a_px, m_px, piece.level + 1});
  }
  out.pop_back();  // the image of b
}

std::vector<Point> clip_to_front(const TagProjection& projection,
                                 const std::vector<Point>& polygon) {
  std::vector<Point> front;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    const double above_a = projection.depth(a) - kNearest;
    const double above_b = projection.depth(b) - kNearest;
    if (above_a >= 0) front.push_back(a);
    if ((above_a >= 0) != (above_b >= 0)) {
      front.push_back(a + above_a / (above_a - above_b) * (b - a));
    }
  }
  return front;
}

double fold_radius(const detect::Camera& camera) {
  // d/dr of r (1 + k1 r^2 + k2 r^4 + k3 r^6), as a polynomial in s = r^2; its first zero by steps
  // of a thousandth, up to 84 degrees off axis.
  constexpr double kStep = 1e-3;
  constexpr double kFarthest = 10;
  for (double r = kStep; r < kFarthest; r += kStep) {
    const double s = r * r;
    if (1 + s * (3 * camera.k1 + s * (5 * camera.k2 + s * 7 * camera.k3)) <= 0) return r;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace tagmint::scene
