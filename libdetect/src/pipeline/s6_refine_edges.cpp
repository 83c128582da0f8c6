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
/// Cells below this width, px, are small: their neighbours' edges are within the blur of a camera.
constexpr double kSmallCellPx = 4.0;
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

/// Gray values along a normal of a side, brighter outwards where the edge has the wanted sense.
struct Profile {
  double t = 0;        ///< foot of the normal along the side, px
  double step = 0;     ///< px between neighbouring values
  int reach = 0;       ///< steps from the foot to either end of the search
  int steepest = 0;    ///< change(steepest) is the largest
  double darkest = 0;  ///< of all values
  double brightest = 0;
  std::array<double, 2 * (kMaxReach + kHalfDifference) + 1> gray;

  int changes() const { return 2 * reach + 1; }
  /// Difference over the four steps around place_of(i), 0 <= i < changes().
  double change(int i) const { return gray[i + 2 * kHalfDifference] - gray[i]; }
  /// Offset along the normal of change i, px; fractions lie between.
  double place_of(double i) const { return (i - reach) * step; }
};

/// The profile along the normal at `foot`, `search` px either way; nothing when it leaves the image
/// or has no edge of the wanted sense.
std::optional<Profile> read_profile(ImageView full, Point foot, Point outward, double search,
                                    double sign) {
  Profile p;
  p.step = std::max(kStep, search / kMaxReach);
  p.reach = std::min(kMaxReach, static_cast<int>(std::ceil(search / p.step)));
  const int values = p.changes() + 2 * kHalfDifference;
  const Point start = foot + p.place_of(-kHalfDifference) * outward;
  const Point step = p.step * outward;
  if (!well_inside(full, start) || !well_inside(full, start + (values - 1) * step)) {
    return std::nullopt;
  }
  for (int i = 0; i < values; ++i) p.gray[i] = sign * sample_inside(full, start + i * step);
  for (int i = 1; i < p.changes(); ++i) {
    if (p.change(i) > p.change(p.steepest)) p.steepest = i;
  }
  if (p.change(p.steepest) < kMinChange) return std::nullopt;
  const auto [darkest, brightest] = std::minmax_element(p.gray.begin(), p.gray.begin() + values);
  p.darkest = *darkest;
  p.brightest = *brightest;
  return p;
}

/// Mean place of the changes around the steepest one.
double mean_place(const Profile& p) {
  // On both sides down to the same share of the peak, so that the mean is not drawn to the side
  // where the search happens to reach farther.
  const double floor = kEdgeShare * p.change(p.steepest);
  int begin = p.steepest;
  int end = p.steepest;
  while (begin > 0 && p.change(begin - 1) > floor) --begin;
  while (end + 1 < p.changes() && p.change(end + 1) > floor) ++end;
  double sum = 0;
  double moment = 0;
  for (int i = begin; i <= end; ++i) {
    sum += p.change(i) - floor;
    moment += (p.change(i) - floor) * p.place_of(i);
  }
  return moment / sum;
}

/// Where the profile passes `level` going up, nearest to the steepest change.
std::optional<double> crossing_place(const Profile& p, double level) {
  const int middle = p.steepest + kHalfDifference;  // index into gray
  const int last = p.changes() + 2 * kHalfDifference - 1;
  for (int away = 0; away <= last; ++away) {
    for (const int i : {middle - 1 - away, middle + away}) {
      if (i < 0 || i >= last || p.gray[i] > level || p.gray[i + 1] <= level) continue;
      const double part = (level - p.gray[i]) / (p.gray[i + 1] - p.gray[i]);
      return p.place_of(i + part - kHalfDifference);
    }
  }
  return std::nullopt;
}

/// Profiles at places spread over one side, those without an edge left out; how many places were
/// looked at goes to `places`.
std::vector<Profile> read_profiles(ImageView full, const Side& side, double search, double sign,
                                   int& places) {
  const double margin = std::min(kCornerMargin, kCornerShare * side.length);
  const double usable = side.length - 2 * margin;
  places = std::clamp(static_cast<int>(usable), kMinEdgeSamples, kMaxEdgeSamples);
  std::vector<Profile> profiles;
  for (int i = 0; i < places; ++i) {
    const double t = margin + (i + 0.5) / places * usable;
    std::optional<Profile> found =
        read_profile(full, side.from + t * side.along, side.outward, search, sign);
    if (!found) continue;
    found->t = t;
    profiles.push_back(*found);
  }
  return profiles;
}

/// Edge points of one side. Where the ring's cells are wide, each profile says by itself where its
/// edge is. Where they are small, a cell of the other colour behind the ring lies within the blur:
/// it draws the mean of the changes outwards and keeps the ring from its full gray level. The place
/// half-way between black and white hardly moves, and some profile of the side shows full black,
/// some full white; noise moves both ends of that range alike, so not their middle.
std::vector<EdgePoint> edge_points(std::span<const Profile> profiles, bool small_cells) {
  double darkest = 255;
  double brightest = -255;
  for (const Profile& p : profiles) {
    darkest = std::min(darkest, p.darkest);
    brightest = std::max(brightest, p.brightest);
  }
  const double level = (darkest + brightest) / 2;
  std::vector<EdgePoint> points;
  for (const Profile& p : profiles) {
    const std::optional<double> d =
        small_cells ? crossing_place(p, level) : std::optional(mean_place(p));
    const double contrast = p.brightest - p.darkest;
    if (d) points.push_back({p.t, *d, contrast * contrast});
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
Line refined_line(ImageView full, const Side& side, double search, double sign, bool small_cells) {
  int places = 0;
  std::vector<EdgePoint> points =
      edge_points(read_profiles(full, side, search, sign, places), small_cells);
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
                                   double sign, bool small_cells) {
  std::array<Line, 4> lines;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Side> side = side_of(corners, i);
    if (!side) return std::nullopt;
    lines[i] = refined_line(full, *side, search, sign, small_cells);
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
  const bool small_cells =
      options.cells_at_border > 0 && side_px < kSmallCellPx * options.cells_at_border;
  Quad refined = quad;
  for (const double reach : {search, std::min(search, kFineSearch)}) {
    const std::optional<Corners> corners =
        refine_once(full, refined.corners, reach, sign, small_cells);
    if (!corners) break;
    refined.corners = *corners;
  }
  return refined;
}

}  // namespace tagmint::detect
