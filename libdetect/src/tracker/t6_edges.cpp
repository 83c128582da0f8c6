#include "tracker/t6_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "kernels/edge_kernels.h"

namespace tagmint::detect {
namespace {

/// Ends of a side without scan lines, px: there the neighbouring side shapes the gray values. At
/// least one pixel, but no more than this share of the side.
constexpr double kEndShare = 0.08;
constexpr double kLargestEndShare = 0.2;
/// Scan lines that must have found the edge: this many, and this share.
constexpr int kMinPoints = 3;
constexpr double kMinPointShare = 0.5;
/// Points farther from the line than this many times their mean distance are let go of.
constexpr double kOutlier = 2.5;
/// Places are whole numbers of parts.
constexpr double kRounding = 1;
/// A side whose points scatter by more (rms) is not straight: px, and a share of its length for
/// lenses that bend it.
constexpr double kMaxScatterPx = 0.6;
constexpr double kMaxScatterShare = 0.016;
/// Sides this near to the edge of the picture may be cut by it, px.
constexpr double kEdgePx = 2.0;
/// Sine of the least angle between neighbouring sides.
constexpr double kMinSine = 0.1;
/// Corners may move by this many px and this share of the mean side.
constexpr double kMaxShiftPx = 3.5;
constexpr double kMaxShiftShare = 0.1;

/// A side, and the direction in which scan lines cross it: along is x and across is y, or the
/// reverse. `from` to `to` is counter-clockwise as seen.
struct Side {
  bool level;         ///< nearer to a row than to a column
  double from_along;  ///< px
  double from_across;
  double length;  ///< along, px, > 0
  int direction;  ///< of increasing t: +1 or -1 along
  double slope;   ///< across per along
  int outward;    ///< +1 or -1 across
};

Side side_between(Point from, Point to) {
  const Point step = to - from;
  const bool level = std::abs(step.x) > std::abs(step.y);
  const double along = level ? step.x : step.y;
  const double across = level ? step.y : step.x;
  // Counter-clockwise with y down: going right the outside is below, going down it is on the left.
  const int direction = along > 0 ? 1 : -1;
  return {.level = level,
          .from_along = level ? from.x : from.y,
          .from_across = level ? from.y : from.x,
          .length = std::abs(along),
          .direction = direction,
          .slope = along == 0 ? 0 : across / along,
          .outward = level ? direction : -direction};
}

/// The scan lines of a side, and where their first pixel along is.
struct SideScans {
  EdgeScans lines;
  int first_along = 0;
  int along_step = 1;  ///< pixels that one step of lines.along stands for
};

/// Pixels across the side from `innermost` outwards, clamped to the image, into column i.
void read_scan(ImageView image, const Side& side, int along, int innermost, std::uint8_t flip,
               std::size_t i, EdgeScans& scans) {
  const int last = (side.level ? image.height : image.width) - 1;
  const int outermost = innermost + side.outward * (kScanPixels - 1);
  if (std::min(innermost, outermost) >= 0 && std::max(innermost, outermost) <= last) {
    const std::ptrdiff_t step = side.level ? side.outward * image.stride : side.outward;
    const std::uint8_t* const from =
        side.level ? image.row(innermost) + along : image.row(along) + innermost;
    for (std::size_t k = 0; k < kScanPixels; ++k) {
      scans.gray[k][i] = from[static_cast<std::ptrdiff_t>(k) * step] ^ flip;
    }
    return;
  }
  for (int k = 0; k < kScanPixels; ++k) {
    const int across = std::clamp(innermost + side.outward * k, 0, last);
    scans.gray[static_cast<std::size_t>(k)][i] =
        (side.level ? image.at(along, across) : image.at(across, along)) ^ flip;
  }
}

/// Whole part of a number above -2^20: without a library call.
int whole_part(double value) {
  constexpr int kShift = 1 << 20;
  return static_cast<int>(value + kShift) - kShift;
}

void read_scans(ImageView image, const Side& side, std::uint8_t flip, SideScans& scans) {
  const double end =
      std::min(std::max(1.0, kEndShare * side.length), kLargestEndShare * side.length);
  const double usable = side.length - 2 * end;
  const int wanted = std::clamp(static_cast<int>(usable), kMinPoints, kMaxEdgeScans);
  const double step = side.direction * std::max(1.0, usable / wanted);
  const int pixels_along = side.level ? image.width : image.height;
  scans.along_step = 1 + static_cast<int>(side.length) / kMaxAlong;
  double place = side.from_along + side.direction * end + 0.5 * step;
  std::size_t n = 0;
  for (int i = 0; i < wanted; ++i, place += step) {
    const int along = whole_part(place);
    if (along < 0 || along >= pixels_along) continue;
    const double across = side.from_across + side.slope * (along + 0.5 - side.from_along);
    const int innermost = whole_part(across) - side.outward * (kScanPixels / 2);
    if (n == 0) scans.first_along = along;
    scans.lines.along[n] = (along - scans.first_along) / scans.along_step;
    scans.lines.expected[n] =
        whole_part(kParts * side.outward * (across - (innermost + 0.5)) + 0.5);
    read_scan(image, side, along, innermost, flip, n, scans.lines);
    ++n;
  }
  scans.lines.count = static_cast<int>(n);
}

/// off = mean_off + slope (along - mean_along), in parts of a pixel by steps along.
struct LineFit {
  double mean_along;
  double mean_off;
  double slope;
  double mean_square;  ///< of the distances from the line, parts^2
};

std::optional<LineFit> regress(const EdgeSums& sums) {
  const auto n = static_cast<double>(sums.n);
  const double t = sums.along;
  const double o = sums.off;
  const double spread = n * sums.along_along - t * t;
  if (!(spread > 0)) return std::nullopt;
  const double both = n * sums.along_off - t * o;
  const double slope = both / spread;
  const double square = (n * sums.off_off - o * o - slope * both) / (n * n);
  return LineFit{t / n, o / n, slope, std::max(0.0, square)};
}

struct Line {
  Point through;
  Point direction;
};

/// The line of the edge near a side, off and along as in LineFit; nothing where there is no
/// straight edge.
std::optional<LineFit> fit_line(const EdgeScans& scans, double length_px) {
  EdgePoints points;
  find_edge_points(scans, twice_middle_level(scans), points);
  EdgeSums sums = sum_edge_points(scans, points);
  if (sums.n < kMinPoints || sums.n < kMinPointShare * scans.count) return std::nullopt;
  std::optional<LineFit> fit = regress(sums);
  if (!fit) return std::nullopt;
  drop_far_points(scans, static_cast<float>(fit->mean_off - fit->slope * fit->mean_along),
                  static_cast<float>(fit->slope),
                  static_cast<float>(kOutlier * std::sqrt(fit->mean_square) + kRounding), points);
  const EdgeSums kept = sum_edge_points(scans, points);
  if (kept.n < sums.n && kept.n >= kMinPoints) {
    if (const auto again = regress(kept)) fit = again;
  }
  const double limit = kParts * (kMaxScatterPx + kMaxScatterShare * length_px);
  if (fit->mean_square > limit * limit) return std::nullopt;
  return fit;
}

/// The side's line; nothing where it has no straight edge.
std::optional<Line> fit_side(ImageView image, Point from, Point to, std::uint8_t flip) {
  const Side side = side_between(from, to);
  SideScans scans;
  read_scans(image, side, flip, scans);
  if (scans.lines.count < kMinPoints) return std::nullopt;
  const std::optional<LineFit> fit = fit_line(scans.lines, side.length);
  if (!fit) return std::nullopt;
  const double along = scans.first_along + 0.5 + scans.along_step * fit->mean_along;
  const double across = side.from_across + side.slope * (along - side.from_along) +
                        side.outward * fit->mean_off / kParts;
  const double slope = side.slope + side.outward * fit->slope / (kParts * scans.along_step);
  if (side.level) return Line{{along, across}, {1, slope}};
  return Line{{across, along}, {slope, 1}};
}

/// Whether a side runs along the edge of the picture.
bool is_at_edge(ImageView image, Point from, Point to) {
  const auto both_within = [](double a, double b, double first, double last) {
    return (a <= first && b <= first) || (a >= last && b >= last);
  };
  return both_within(from.x, to.x, kEdgePx, image.width - kEdgePx) ||
         both_within(from.y, to.y, kEdgePx, image.height - kEdgePx);
}

/// Coordinates are far from any overflow of their squares.
double length_of(Point p) { return std::sqrt(dot(p, p)); }

std::optional<Point> meeting(const Line& a, const Line& b) {
  const double area = cross(a.direction, b.direction);
  if (std::abs(area) < kMinSine * length_of(a.direction) * length_of(b.direction))
    return std::nullopt;
  return a.through + (cross(b.through - a.through, b.direction) / area) * a.direction;
}

/// Counter-clockwise as seen, and no corner nearly straight.
bool is_convex(const Corners& corners) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Point before = corners[i] - corners[(i + 3) % 4];
    const Point after = corners[(i + 1) % 4] - corners[i];
    if (cross(before, after) > -kMinSine * length_of(before) * length_of(after)) return false;
  }
  return true;
}

}  // namespace

std::optional<Quad> fit_edges(ImageView image, const Quad& quad, const EdgeOptions& options) {
  const std::uint8_t flip = quad.reversed_border ? 255 : 0;
  std::array<Line, 4> lines;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point from = quad.corners[i];
    const Point to = quad.corners[(i + 1) % 4];
    std::optional<Line> line = fit_side(image, from, to, flip);
    // Where the picture ends there is no edge to see.
    if (!line && is_at_edge(image, from, to)) line = Line{from, to - from};
    if (!line) return std::nullopt;
    lines[i] = *line;
  }
  Quad fitted = quad;
  const double side_px = std::sqrt(std::abs(signed_area(quad.corners)));
  const double most = kMaxShiftPx + kMaxShiftShare * side_px;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Point> corner = meeting(lines[(i + 3) % 4], lines[i]);
    if (!corner || length_of(*corner - quad.corners[i]) > most) return std::nullopt;
    fitted.corners[i] = *corner;
  }
  if (!is_convex(fitted.corners)) return std::nullopt;
  if (-signed_area(fitted.corners) < options.min_side_px * options.min_side_px) return std::nullopt;
  return fitted;
}

}  // namespace tagmint::detect
