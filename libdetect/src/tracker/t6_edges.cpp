#include "tracker/t6_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace tagmint::detect {
namespace {

/// Ends of a side without scan lines, px: there the neighbouring side shapes the gray values. At
/// least one pixel, but no more than this share of the side.
constexpr double kEndShare = 0.08;
constexpr double kLargestEndShare = 0.2;
/// Places are counted in this part of a pixel.
constexpr int kParts = 256;
/// Scan lines that must have found the edge: this many, and this share.
constexpr int kMinPoints = 3;
constexpr double kMinPointShare = 0.5;
/// Points farther from the line than this many times their mean distance are let go of.
constexpr double kOutlier = 2.5;
/// A side whose points scatter by more (rms) is not straight: px, and a share of its length for
/// lenses that bend it.
constexpr double kMaxScatterPx = 0.6;
constexpr double kMaxScatterShare = 0.012;
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

/// What the scan lines of a side read, from inside to outside.
struct Scans {
  int count = 0;
  std::array<std::array<std::uint8_t, kScanPixels>, kMaxEdgeScans> gray;
  std::array<std::int32_t, kMaxEdgeScans> along;      ///< pixel, relative to the first scan line's
  std::array<std::int32_t, kMaxEdgeScans> innermost;  ///< pixel across of gray[i][0]
  std::array<double, kMaxEdgeScans> expected;  ///< where in gray[i] the given side is, in pixels
  int first_along = 0;
};

/// Pixels across the side, clamped to the image.
void read_scan(ImageView image, const Side& side, int along, int innermost, std::uint8_t flip,
               std::array<std::uint8_t, kScanPixels>& gray) {
  const int last = (side.level ? image.height : image.width) - 1;
  const int outermost = innermost + side.outward * (kScanPixels - 1);
  const bool inside = std::min(innermost, outermost) >= 0 && std::max(innermost, outermost) <= last;
  if (inside) {
    const std::ptrdiff_t step = side.outward * (side.level ? image.stride : 1);
    const std::uint8_t* from =
        side.level ? image.row(innermost) + along : image.row(along) + innermost;
    for (std::uint8_t& value : gray) {
      value = *from ^ flip;
      from += step;
    }
    return;
  }
  for (int i = 0; i < kScanPixels; ++i) {
    const int across = std::clamp(innermost + side.outward * i, 0, last);
    gray[static_cast<std::size_t>(i)] =
        (side.level ? image.at(along, across) : image.at(across, along)) ^ flip;
  }
}

void read_scans(ImageView image, const Side& side, std::uint8_t flip, Scans& scans) {
  const double end =
      std::min(std::max(1.0, kEndShare * side.length), kLargestEndShare * side.length);
  const double usable = side.length - 2 * end;
  const int wanted = std::clamp(static_cast<int>(usable), kMinPoints, kMaxEdgeScans);
  const double step = std::max(1.0, usable / wanted);
  const int pixels_along = side.level ? image.width : image.height;
  scans.count = 0;
  for (int i = 0; i < wanted; ++i) {
    const double t = end + (i + 0.5) * step;
    const int along = static_cast<int>(std::floor(side.from_along + side.direction * t));
    if (t > side.length || along < 0 || along >= pixels_along) continue;
    const double across = side.from_across + side.slope * (along + 0.5 - side.from_along);
    const int middle = static_cast<int>(std::floor(across));
    const auto n = static_cast<std::size_t>(scans.count);
    const int innermost = middle - side.outward * (kScanPixels / 2);
    // The place in px from the middle of the innermost pixel, outwards.
    scans.expected[n] = side.outward * (across - (innermost + 0.5));
    scans.innermost[n] = innermost;
    if (n == 0) scans.first_along = along;
    scans.along[n] = along - scans.first_along;
    read_scan(image, side, along, innermost, flip, scans.gray[n]);
    ++scans.count;
  }
}

/// Twice the gray level half-way between the mean of the darkest and of the brightest pixels.
int twice_level(const Scans& scans) {
  int darkest = 0;
  int brightest = 0;
  for (int i = 0; i < scans.count; ++i) {
    const auto [low, high] = std::minmax_element(scans.gray[static_cast<std::size_t>(i)].begin(),
                                                 scans.gray[static_cast<std::size_t>(i)].end());
    darkest += *low;
    brightest += *high;
  }
  return (darkest + brightest) / scans.count;
}

/// A place on the edge: pixel along, parts of a pixel across, outwards from the innermost pixel's
/// middle of the first scan line.
struct EdgePoint {
  std::int32_t along;
  std::int32_t across;
};

/// Where a scan line passes the level from dark to bright, nearest to `expected`; parts of a pixel.
std::optional<int> crossing(const std::array<std::uint8_t, kScanPixels>& gray, int twice_level,
                            double expected) {
  std::optional<int> best;
  const int wanted = static_cast<int>(std::lround(expected * kParts));
  for (int i = 0; i + 1 < kScanPixels; ++i) {
    const int inner = 2 * gray[static_cast<std::size_t>(i)];
    const int outer = 2 * gray[static_cast<std::size_t>(i) + 1];
    if (inner >= twice_level || outer < twice_level) continue;
    const int place = i * kParts + (twice_level - inner) * kParts / (outer - inner);
    if (!best || std::abs(place - wanted) < std::abs(*best - wanted)) best = place;
  }
  return best;
}

/// across = mean_across + slope (along - mean_along), in pixels and parts.
struct LineFit {
  double mean_along;
  double mean_across;
  double slope;
  double mean_square;  ///< of the distances from the line, parts^2
};

using EdgePoints = std::array<EdgePoint, kMaxEdgeScans>;

/// Regression over the first `count` points, in whole numbers.
std::optional<LineFit> regress(const EdgePoints& points, int count) {
  std::int64_t t = 0, d = 0, tt = 0, td = 0, dd = 0;
  for (int i = 0; i < count; ++i) {
    const std::int64_t along = points[static_cast<std::size_t>(i)].along;
    const std::int64_t across = points[static_cast<std::size_t>(i)].across;
    t += along;
    d += across;
    tt += along * along;
    td += along * across;
    dd += across * across;
  }
  const std::int64_t spread = count * tt - t * t;
  if (spread <= 0) return std::nullopt;
  const std::int64_t both = count * td - t * d;
  const double n = count;
  const double slope = static_cast<double>(both) / static_cast<double>(spread);
  const double square =
      (static_cast<double>(count * dd - d * d) - slope * static_cast<double>(both)) / (n * n);
  return LineFit{static_cast<double>(t) / n, static_cast<double>(d) / n, slope,
                 std::max(0.0, square)};
}

/// Leaves the points near the line; returns how many.
int keep_near(const LineFit& fit, EdgePoints& points, int count) {
  const double limit = kOutlier * std::sqrt(fit.mean_square);
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const EdgePoint p = points[static_cast<std::size_t>(i)];
    const double off = p.across - fit.mean_across - fit.slope * (p.along - fit.mean_along);
    if (std::abs(off) <= limit) points[static_cast<std::size_t>(kept++)] = p;
  }
  return kept;
}

struct Line {
  Point through;
  Point direction;
};

/// The side's line; nothing where it has no straight edge.
std::optional<Line> fit_side(ImageView image, Point from, Point to, std::uint8_t flip) {
  const Side side = side_between(from, to);
  Scans scans;
  read_scans(image, side, flip, scans);
  if (scans.count < kMinPoints) return std::nullopt;
  const int level = twice_level(scans);
  EdgePoints points;
  int count = 0;
  for (int i = 0; i < scans.count; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const std::optional<int> place = crossing(scans.gray[n], level, scans.expected[n]);
    if (!place) continue;
    const int steps = side.outward * (scans.innermost[n] - scans.innermost[0]);
    points[static_cast<std::size_t>(count++)] = {scans.along[n], steps * kParts + *place};
  }
  if (count < kMinPoints || count < kMinPointShare * scans.count) return std::nullopt;
  std::optional<LineFit> fit = regress(points, count);
  if (!fit) return std::nullopt;
  const int kept = keep_near(*fit, points, count);
  if (kept < count && kept >= kMinPoints) {
    if (const auto again = regress(points, kept)) fit = again;
  }
  const double limit = kParts * (kMaxScatterPx + kMaxScatterShare * side.length);
  if (fit->mean_square > limit * limit) return std::nullopt;
  const double along = scans.first_along + 0.5 + fit->mean_along;
  const double across = scans.innermost[0] + 0.5 + side.outward * fit->mean_across / kParts;
  const double slope = side.outward * fit->slope / kParts;
  if (side.level) return Line{{along, across}, {1, slope}};
  return Line{{across, along}, {slope, 1}};
}

std::optional<Point> meeting(const Line& a, const Line& b) {
  const double area = cross(a.direction, b.direction);
  if (std::abs(area) < kMinSine * length(a.direction) * length(b.direction)) return std::nullopt;
  return a.through + (cross(b.through - a.through, b.direction) / area) * a.direction;
}

/// Counter-clockwise as seen, and no corner nearly straight.
bool is_convex(const Corners& corners) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Point before = corners[i] - corners[(i + 3) % 4];
    const Point after = corners[(i + 1) % 4] - corners[i];
    if (cross(before, after) > -kMinSine * length(before) * length(after)) return false;
  }
  return true;
}

}  // namespace

std::optional<Quad> fit_edges(ImageView image, const Quad& quad, const EdgeOptions& options) {
  const std::uint8_t flip = quad.reversed_border ? 255 : 0;
  std::array<Line, 4> lines;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Line> line =
        fit_side(image, quad.corners[i], quad.corners[(i + 1) % 4], flip);
    if (!line) return std::nullopt;
    lines[i] = *line;
  }
  Quad fitted = quad;
  const double side_px = std::sqrt(std::abs(signed_area(quad.corners)));
  const double most = kMaxShiftPx + kMaxShiftShare * side_px;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Point> corner = meeting(lines[(i + 3) % 4], lines[i]);
    if (!corner || length(*corner - quad.corners[i]) > most) return std::nullopt;
    fitted.corners[i] = *corner;
  }
  if (!is_convex(fitted.corners)) return std::nullopt;
  if (-signed_area(fitted.corners) < options.min_side_px * options.min_side_px) return std::nullopt;
  return fitted;
}

}  // namespace tagmint::detect
