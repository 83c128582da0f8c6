#include "pipeline/s6_refine_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "numerics/normal_profile.h"

namespace tagmint::detect {
namespace {

/// Search of the second round, from the sides that the first one found, px.
constexpr double kFineSearch = 1.5;
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

/// The first round only brings the sides near enough for the second: it looks at every third place.
constexpr int kCoarseStride = 3;
constexpr int kMinCoarseSamples = 5;

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

/// A profile across a side, and where on the side its foot is.
struct PlacedProfile {
  double t = 0;  ///< px
  NormalProfile profile;
};

struct EdgeScratch {
  std::array<PlacedProfile, kMaxEdgeSamples> profiles;
  std::size_t found = 0;  ///< of them in use
  std::vector<EdgePoint> points;
  std::vector<EdgePoint> weighted;
  std::vector<double> distances;
  std::vector<double> sorted;
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

/// How a round looks for edges.
struct Search {
  double reach_px = 0;
  int stride = 1;      ///< of the places along a side
  bool rising = true;  ///< gray values rise outwards
  bool small_cells = false;
};

/// Profiles at places spread over one side, those without an edge left out; returns how many places
/// were looked at.
int read_profiles(ImageView full, const Side& side, const Search& search, EdgeScratch& s) {
  const double margin = std::min(kCornerMargin, kCornerShare * side.length);
  const double usable = side.length - 2 * margin;
  const int places =
      std::clamp(static_cast<int>(usable) / search.stride,
                 search.stride > 1 ? kMinCoarseSamples : kMinEdgeSamples, kMaxEdgeSamples);
  const ProfileReader reader(full, side.outward, search.reach_px, search.rising);
  s.found = 0;
  for (int i = 0; i < places; ++i) {
    PlacedProfile& placed = s.profiles[s.found];
    placed.t = margin + (i + 0.5) / places * usable;
    if (reader.read(side.from + placed.t * side.along, placed.profile)) ++s.found;
  }
  return places;
}

/// Edge points of one side. Where the ring's cells are wide, each profile says by itself where its
/// edge is. Where they are small, a cell of the other colour behind the ring lies within the blur:
/// it draws the mean of the changes outwards and keeps the ring from its full gray level. The place
/// half-way between black and white hardly moves, and some profile of the side shows full black,
/// some full white; noise moves both ends of that range alike, so not their middle.
void find_edge_points(std::span<const PlacedProfile> profiles, bool small_cells,
                      std::vector<EdgePoint>& points) {
  float darkest = 255;
  float brightest = -255;
  for (const auto& [t, profile] : profiles) {
    darkest = std::min(darkest, profile.darkest);
    brightest = std::max(brightest, profile.brightest);
  }
  const float level = (darkest + brightest) / 2;
  points.clear();
  for (const auto& [t, profile] : profiles) {
    const std::optional<float> d = small_cells ? crossing_place(profile, level)
                                               : std::optional(mean_place_of_changes(profile));
    const double contrast = profile.brightest - profile.darkest;
    if (d) points.push_back({t, *d, contrast * contrast});
  }
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
std::optional<SideFit> fit_side(EdgeScratch& s) {
  constexpr int kRounds = 3;
  constexpr double kLeastScale = 0.05;  // px
  std::optional<SideFit> fit = regress(s.points);
  s.weighted = s.points;
  for (int round = 0; fit && round < kRounds; ++round) {
    s.distances.clear();
    for (const EdgePoint& p : s.points) {
      s.distances.push_back(std::abs(p.d - fit->offset - fit->slope * p.t));
    }
    s.sorted = s.distances;
    const auto median = s.sorted.begin() + static_cast<std::ptrdiff_t>(s.sorted.size() / 2);
    std::nth_element(s.sorted.begin(), median, s.sorted.end());
    const double scale = std::max(kLeastScale, 2 * *median);
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const double r = s.distances[i] / scale;
      s.weighted[i].weight = s.points[i].weight / (1 + r * r);
    }
    fit = regress(s.weighted);
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
Line refined_line(ImageView full, const Side& side, const Search& search, EdgeScratch& s) {
  const int places = read_profiles(full, side, search, s);
  find_edge_points({s.profiles.data(), s.found}, search.small_cells, s.points);
  const auto found = static_cast<int>(s.points.size());
  if (found >= kMinEdgePoints && found >= kMinEdgeShare * places) {
    if (const std::optional<SideFit> fit = fit_side(s)) {
      return {side.from + fit->offset * side.outward, side.along + fit->slope * side.outward};
    }
  }
  return {side.from, side.along};
}

/// One round: each side again, then the corners; nothing when no quad comes of it.
std::optional<Corners> refine_once(ImageView full, const Corners& corners, const Search& search,
                                   EdgeScratch& scratch) {
  std::array<Line, 4> lines;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Side> side = side_of(corners, i);
    if (!side) return std::nullopt;
    lines[i] = refined_line(full, *side, search, scratch);
  }
  Corners refined;
  for (int i = 0; i < 4; ++i) {
    const std::optional<Point> corner = intersection(lines[(i + 3) % 4], lines[i]);
    if (!corner || length(*corner - corners[i]) > kMaxShift * search.reach_px) return std::nullopt;
    refined[i] = *corner;
  }
  if (!is_convex(refined)) return std::nullopt;
  return refined;
}

}  // namespace

Quad refine_edges(ImageView full, const Quad& quad, const RefineOptions& options) {
  const double side_px = std::sqrt(std::abs(signed_area(quad.corners)));
  Search search{.reach_px = options.search_px, .rising = !quad.reversed_border};
  if (options.cells_at_border > 0) {
    search.reach_px = std::min(search.reach_px, kSearchCells * side_px / options.cells_at_border);
    search.small_cells = side_px < kSmallCellPx * options.cells_at_border;
  }
  Quad refined = quad;
  EdgeScratch scratch;
  for (const int stride : {kCoarseStride, 1}) {
    search.stride = stride;
    if (stride == 1) search.reach_px = std::min(search.reach_px, kFineSearch);
    const std::optional<Corners> corners = refine_once(full, refined.corners, search, scratch);
    if (!corners) break;
    refined.corners = *corners;
  }
  return refined;
}

}  // namespace tagmint::detect
