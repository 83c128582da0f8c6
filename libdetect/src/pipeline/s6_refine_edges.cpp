#include "pipeline/s6_refine_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "numerics/bilinear.h"

namespace tagmint::detect {
namespace {

/// Distance of neighbouring gray values along a normal, px: small against an edge's width. A wide
/// first search takes larger steps, so that it costs no more than kMaxReach steps either way.
constexpr double kStep = 0.25;
constexpr int kMaxReach = 16;
/// Search of the second round, from the sides that the first one found, px.
constexpr double kFineSearch = 1.5;
/// The gradient is the difference over +-2 steps, half a pixel: as wide as a pixel, so that it
/// neither doubles the noise nor blurs a sharp edge much.
constexpr int kHalfDifference = 2;
/// Changes below this share of the steepest one belong to noise, not to the edge.
constexpr double kEdgeShare = 0.25;
/// Gray levels; flatter places have no edge.
constexpr double kMinChange = 2.0;
/// The next edge of the same sign is two cells away, so the search may reach this many cells.
constexpr double kSearchCells = 1.25;
/// Ends of a side without samples, px: there the neighbouring side shapes the gray values. At most
/// this share of the side.
constexpr double kCornerMargin = 2.0;
constexpr double kCornerShare = 0.2;
/// Places that a side needs to be fitted again, and the share of those looked at.
constexpr int kMinEdgePoints = 4;
constexpr double kMinEdgeShare = 0.3;
/// A corner may move by this many times the search of its sides: at a slanted corner, lines that
/// move by the search move their intersection by more.
constexpr double kMaxShift = 3.0;

/// A side of the quad: from + along * t, t in [0, length]; `outward` points away from the quad.
struct Side {
  Point from;
  Point along;
  Point outward;
  double length = 0;
};

/// A place where an edge was found: t along the side, d outward from it, px.
struct EdgePoint {
  double t = 0;
  double d = 0;
  double weight = 0;
};

/// d = offset + slope * t in the frame of a Side.
struct SideFit {
  double offset = 0;
  double slope = 0;
};

struct Line {
  Point through;
  Point direction;
};

std::optional<Side> side_of(const Corners& corners, int i) {
  const Point from = corners[i];
  const Point step = corners[(i + 1) % 4] - from;
  const double side_length = length(step);
  if (!(side_length > 0)) return std::nullopt;
  const Point along = (1 / side_length) * step;
  // Counter-clockwise as seen with y down: the inside is on the left, so outward is to the right.
  return Side{from, along, {-along.y, along.x}, side_length};
}

/// Where the gray values along the normal at `foot` change most in the wanted sense, within
/// `search` px either way: the mean place of the changes around the steepest one. t is left at
/// zero.
/// Where cells are so small that the ring's far edge is within the blur, a cell of the other colour
/// behind the ring pulls the place outwards and keeps the ring from reaching its full gray level;
/// weights by the fourth power of the contrast prefer the places without one.
std::optional<EdgePoint> find_edge(ImageView full, Point foot, Point outward, double search,
                                   double sign) {
  const double step = std::max(kStep, search / kMaxReach);
  const int reach = std::min(kMaxReach, static_cast<int>(std::ceil(search / step)));
  std::array<double, 2 * (kMaxReach + kHalfDifference) + 1> gray;
  const int values = 2 * (reach + kHalfDifference) + 1;
  for (int i = 0; i < values; ++i) {
    const double d = (i - reach - kHalfDifference) * step;
    const std::optional<double> value = sample_bilinear(full, foot + d * outward);
    if (!value) return std::nullopt;
    gray[i] = sign * *value;
  }
  const auto change = [&](int i) { return gray[i + 2 * kHalfDifference] - gray[i]; };
  const int changes = 2 * reach + 1;
  int steepest = 0;
  for (int i = 1; i < changes; ++i) {
    if (change(i) > change(steepest)) steepest = i;
  }
  const double peak = change(steepest);
  if (peak < kMinChange) return std::nullopt;
  // On both sides down to the same share of the peak, so that the mean is not drawn to the side
  // where the search happens to reach farther.
  const double floor = kEdgeShare * peak;
  int begin = steepest;
  int end = steepest;
  while (begin > 0 && change(begin - 1) > floor) --begin;
  while (end + 1 < changes && change(end + 1) > floor) ++end;
  double sum = 0;
  double moment = 0;
  for (int i = begin; i <= end; ++i) {
    sum += change(i) - floor;
    moment += (change(i) - floor) * (i - reach) * step;
  }
  const auto [darkest, brightest] = std::minmax_element(gray.begin(), gray.begin() + values);
  const double contrast = *brightest - *darkest;
  return EdgePoint{0, moment / sum, contrast * contrast * contrast * contrast};
}

/// Edge points of one side; how many places were looked at goes to `places`.
std::vector<EdgePoint> find_edge_points(ImageView full, const Side& side, double search,
                                        double sign, int& places) {
  const double margin = std::min(kCornerMargin, kCornerShare * side.length);
  const double usable = side.length - 2 * margin;
  places = std::clamp(static_cast<int>(usable), kMinEdgeSamples, kMaxEdgeSamples);
  std::vector<EdgePoint> points;
  for (int i = 0; i < places; ++i) {
    const double t = margin + (i + 0.5) / places * usable;
    std::optional<EdgePoint> found =
        find_edge(full, side.from + t * side.along, side.outward, search, sign);
    if (!found) continue;
    found->t = t;
    points.push_back(*found);
  }
  return points;
}

/// Weighted regression of d on t; nothing when all places are one.
std::optional<SideFit> regress(std::span<const EdgePoint> points) {
  double w = 0, t = 0, d = 0, tt = 0, td = 0;
  for (const EdgePoint& p : points) {
    w += p.weight;
    t += p.weight * p.t;
    d += p.weight * p.d;
  }
  if (!(w > 0)) return std::nullopt;
  const double mean_t = t / w;
  const double mean_d = d / w;
  for (const EdgePoint& p : points) {
    tt += p.weight * (p.t - mean_t) * (p.t - mean_t);
    td += p.weight * (p.t - mean_t) * (p.d - mean_d);
  }
  if (!(tt > 0)) return std::nullopt;
  const double slope = td / tt;
  return SideFit{mean_d - slope * mean_t, slope};
}

/// Regression that lets go of places far from the line: each round weights a place by
/// 1 / (1 + (r / scale)^2), with the scale twice the median distance from the line before.
std::optional<SideFit> fit_side(std::vector<EdgePoint>& points) {
  constexpr int kRounds = 3;
  constexpr double kLeastScale = 0.05;  // px
  std::optional<SideFit> fit = regress(points);
  std::vector<double> distances(points.size());
  std::vector<EdgePoint> weighted = points;
  for (int round = 0; fit && round < kRounds; ++round) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      distances[i] = std::abs(points[i].d - fit->offset - fit->slope * points[i].t);
    }
    std::vector<double> sorted = distances;
    const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), median, sorted.end());
    const double scale = std::max(kLeastScale, 2 * *median);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double r = distances[i] / scale;
      weighted[i].weight = points[i].weight / (1 + r * r);
    }
    fit = regress(weighted);
  }
  return fit;
}

std::optional<Point> intersection(const Line& a, const Line& b) {
  const double sine = cross(a.direction, b.direction) / (length(a.direction) * length(b.direction));
  if (std::abs(sine) < 1e-3) return std::nullopt;
  const double s = cross(b.through - a.through, b.direction) / cross(a.direction, b.direction);
  return a.through + s * a.direction;
}

bool is_convex(const Corners& corners) {
  for (int i = 0; i < 4; ++i) {
    const Point& corner = corners[i];
    if (cross(corner - corners[(i + 3) % 4], corners[(i + 1) % 4] - corner) >= 0) return false;
  }
  return true;
}

/// The side's line after a fit, or the side itself where there is no edge to fit.
Line refined_line(ImageView full, const Side& side, double search, double sign) {
  int places = 0;
  std::vector<EdgePoint> points = find_edge_points(full, side, search, sign, places);
  const auto found = static_cast<int>(points.size());
  if (found >= kMinEdgePoints && found >= kMinEdgeShare * places) {
    if (const std::optional<SideFit> fit = fit_side(points)) {
      return {side.from + fit->offset * side.outward, side.along + fit->slope * side.outward};
    }
  }
  return {side.from, side.along};
}

/// One round: each side again, then the corners; nothing when no quad comes of it.
std::optional<Corners> refine_once(ImageView full, const Corners& corners, double search,
                                   double sign) {
  std::array<Line, 4> lines;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Side> side = side_of(corners, i);
    if (!side) return std::nullopt;
    lines[i] = refined_line(full, *side, search, sign);
  }
  Corners refined;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Point> corner = intersection(lines[(i + 3) % 4], lines[i]);
    if (!corner || length(*corner - corners[i]) > kMaxShift * search) return std::nullopt;
    refined[i] = *corner;
  }
  if (!is_convex(refined)) return std::nullopt;
  return refined;
}

}  // namespace

Quad refine_edges(ImageView full, const Quad& quad, const RefineOptions& options) {
  const double sign = quad.reversed_border ? -1 : 1;
  const double side_px = std::sqrt(std::abs(signed_area(quad.corners)));
  double search = options.search_px;
  if (options.cells_at_border > 0) {
    search = std::min(search, kSearchCells * side_px / options.cells_at_border);
  }
  Quad refined = quad;
  for (const double reach : {search, std::min(search, kFineSearch)}) {
    const std::optional<Corners> corners = refine_once(full, refined.corners, reach, sign);
    if (!corners) break;
    refined.corners = *corners;
  }
  return refined;
}

}  // namespace tagmint::detect
