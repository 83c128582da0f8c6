#include "pipeline/s8_reconcile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "numerics/polygon_overlap.h"
#include "tagmint/codec/family_stats.h"

namespace tagmint::detect {
namespace {

/// Two tags in one plane share no area; what rounding and noise make of tags that touch stays below
/// this share of the smaller one.
constexpr double kMaxOverlapShare = 0.01;

bool overlap(const Detection& a, const Detection& b) {
  const double smaller =
      std::min(std::abs(signed_area(a.corners)), std::abs(signed_area(b.corners)));
  return overlap_area(a.corners, b.corners) > kMaxOverlapShare * smaller;
}

bool same_tag(const Detection& a, const Detection& b) {
  return a.id == b.id && a.family->name() == b.family->name();
}

/// Place of a detection as a key that orders any two that differ in it.
auto place(const Detection& d) {
  const Corners& c = d.corners;
  return std::make_tuple(d.center.y, d.center.x, c[0].y, c[0].x, c[1].y, c[1].x, c[2].y, c[2].x,
                         c[3].y, c[3].x);
}

/// Tags together, the best reading of each first.
bool better_first(const Detection& a, const Detection& b) {
  if (const int order = a.family->name().compare(b.family->name()); order != 0) return order < 0;
  if (a.id != b.id) return a.id < b.id;
  if (a.hamming != b.hamming) return a.hamming < b.hamming;
  if (a.decision_margin != b.decision_margin) return a.decision_margin > b.decision_margin;
  return place(a) < place(b);
}

bool output_order(const Detection& a, const Detection& b) {
  if (const int order = a.family->name().compare(b.family->name()); order != 0) return order < 0;
  if (a.id != b.id) return a.id < b.id;
  return place(a) < place(b);
}

/// The quad that was read, from the same corner on whichever way up the tag was read.
std::array<double, 8> quad_of(const Detection& d) {
  const auto before = [](Point a, Point b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); };
  const auto first = static_cast<std::size_t>(
      std::min_element(d.corners.begin(), d.corners.end(), before) - d.corners.begin());
  std::array<double, 8> quad;
  for (std::size_t i = 0; i < 4; ++i) {
    quad[2 * i] = d.corners[(first + i) % 4].x;
    quad[2 * i + 1] = d.corners[(first + i) % 4].y;
  }
  return quad;
}

/// How likely the reading is an accident.
double chance_of(const Detection& d) {
  return codec::false_accept_rate(d.family->size(), d.family->bits(), d.hamming);
}

bool more_credible(const Detection& a, const Detection& b) {
  const double chance_a = chance_of(a), chance_b = chance_of(b);
  if (chance_a != chance_b) return chance_a < chance_b;
  if (a.decision_margin != b.decision_margin) return a.decision_margin > b.decision_margin;
  return better_first(a, b);
}

/// One border square is one tag: of its readings in several families the most credible stays.
void keep_one_of_each_quad(std::vector<Detection>& candidates) {
  const auto same_family = [&](const Detection& d) {
    return d.family == candidates.front().family;
  };
  // A family reads a quad once.
  if (std::all_of(candidates.begin(), candidates.end(), same_family)) return;
  std::sort(candidates.begin(), candidates.end(), [](const Detection& a, const Detection& b) {
    const auto quad_a = quad_of(a), quad_b = quad_of(b);
    return quad_a != quad_b ? quad_a < quad_b : more_credible(a, b);
  });
  candidates.erase(
      std::unique(candidates.begin(), candidates.end(),
                  [](const Detection& a, const Detection& b) { return quad_of(a) == quad_of(b); }),
      candidates.end());
}

/// Of overlapping detections of one tag the best stays; they come tags together, the best first.
void keep_one_of_each_place(std::vector<Detection>& candidates) {
  std::size_t kept = 0;
  std::size_t group = 0;  // where the kept detections of the current tag begin
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (kept > 0 && !same_tag(candidates[kept - 1], candidates[i])) group = kept;
    const auto kept_of_tag = std::span(candidates).subspan(group, kept - group);
    if (std::any_of(kept_of_tag.begin(), kept_of_tag.end(),
                    [&](const Detection& better) { return overlap(better, candidates[i]); })) {
      continue;
    }
    if (kept != i) candidates[kept] = std::move(candidates[i]);
    ++kept;
  }
  candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(kept), candidates.end());
}

}  // namespace

void sort_detections(std::vector<Detection>& detections) {
  std::sort(detections.begin(), detections.end(), output_order);
}

void reconcile(std::vector<Detection>& detections, DetectStats& stats) {
  const std::size_t read = detections.size();
  keep_one_of_each_quad(detections);
  std::sort(detections.begin(), detections.end(), better_first);
  keep_one_of_each_place(detections);
  sort_detections(detections);
  stats.duplicates += static_cast<std::int64_t>(read - detections.size());
  stats.detections += static_cast<std::int64_t>(detections.size());
}

}  // namespace tagmint::detect
