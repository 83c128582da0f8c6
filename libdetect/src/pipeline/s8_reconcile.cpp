#include "pipeline/s8_reconcile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
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

/// The same corners from the same one on, whichever way up the tag was read.
Corners from_first_corner(Corners corners) {
  const auto before = [](Point a, Point b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), before),
              corners.end());
  return corners;
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
std::vector<Detection> one_of_each_quad(std::vector<Detection> candidates) {
  std::map<std::array<double, 8>, std::size_t> place_in_kept;
  std::vector<Detection> kept;
  kept.reserve(candidates.size());
  for (Detection& candidate : candidates) {
    const Corners c = from_first_corner(candidate.corners);
    const std::array<double, 8> quad = {c[0].x, c[0].y, c[1].x, c[1].y,
                                        c[2].x, c[2].y, c[3].x, c[3].y};
    const auto [known, is_new] = place_in_kept.emplace(quad, kept.size());
    if (is_new) {
      kept.push_back(std::move(candidate));
    } else if (Detection& rival = kept[known->second]; more_credible(candidate, rival)) {
      rival = std::move(candidate);
    }
  }
  return kept;
}

}  // namespace

void sort_detections(std::vector<Detection>& detections) {
  std::sort(detections.begin(), detections.end(), output_order);
}

std::vector<Detection> reconcile(std::vector<Detection> candidates, DetectStats& stats) {
  const std::size_t read = candidates.size();
  candidates = one_of_each_quad(std::move(candidates));
  stats.duplicates += static_cast<std::int64_t>(read - candidates.size());
  std::sort(candidates.begin(), candidates.end(), better_first);
  std::vector<Detection> kept;
  kept.reserve(candidates.size());
  std::size_t group = 0;  // where the kept detections of the current tag begin
  for (Detection& candidate : candidates) {
    if (!kept.empty() && !same_tag(kept.back(), candidate)) group = kept.size();
    const bool duplicate =
        std::any_of(kept.begin() + static_cast<std::ptrdiff_t>(group), kept.end(),
                    [&](const Detection& better) { return overlap(better, candidate); });
    if (duplicate) {
      ++stats.duplicates;
    } else {
      kept.push_back(std::move(candidate));
    }
  }
  sort_detections(kept);
  stats.detections += static_cast<std::int64_t>(kept.size());
  return kept;
}

}  // namespace tagmint::detect
