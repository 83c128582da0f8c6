#include "evaluate/sighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scene/projection.h"
#include "tagmint/detect/pose.h"

namespace tagmint::evaluate {
namespace {

using detect::Corners;
using detect::Point;

/// A tag with less of it to be seen is not asked for. Where tags touch, a pixel on the seam counts
/// less than once.
constexpr double kSeen = 0.7;

Point middle_of(const Corners& c) { return 0.25 * (c[0] + c[1] + c[2] + c[3]); }
double side_of(const Corners& c) { return std::sqrt(std::abs(signed_area(c))); }

/// Whether all of the tag, its outermost ring too, is inside the picture.
bool is_inside(const scene::SceneTag& tag, const scene::Scene& scene) {
  const codec::Layout& layout = tag.family->layout();
  const double reach = static_cast<double>(layout.width()) / layout.width_at_border();
  const scene::TagProjection projection(tag, scene.camera);
  return std::all_of(detect::kTagCorners.begin(), detect::kTagCorners.end(), [&](Point corner) {
    const Point p = projection.project(reach * corner);
    return p.x >= 0 && p.y >= 0 && p.x <= scene.width && p.y <= scene.height;
  });
}

double norm(const std::array<double, 3>& t) { return std::hypot(t[0], t[1], t[2]); }

/// Angle of the rotation that takes a to b: trace(a^T b) = 1 + 2 cos.
double angle_between_deg(const std::array<double, 9>& a, const std::array<double, 9>& b) {
  const double trace = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

Sighting measure(const FoundTag& report, const Corners& truth, const scene::SceneTag& tag,
                 const detect::Camera& camera) {
  Sighting sighting{.found = true};
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point error = report.corners[k] - truth[k];
    sum += dot(error, error);
  }
  sighting.corner_error_px = std::sqrt(sum / 4);
  const auto* posed = std::get_if<scene::PosedTag>(&tag.place);
  if (posed == nullptr) return sighting;
  const auto estimate =
      detect::estimate_pose(report.corners, camera, posed->edge_m, report.covariance);
  if (!estimate) return sighting;
  sighting.distance_error_m = norm(estimate->best.t) - norm(posed->pose.t);
  sighting.orientation_error_deg = angle_between_deg(estimate->best.R, posed->pose.R);
  return sighting;
}

}  // namespace

View judge(std::span<const FoundTag> reports, const scene::Scene& scene,
           std::span<const scene::TagTruth> truth) {
  std::vector<Sighting> all(scene.tags.size());
  View view;
  for (const FoundTag& report : reports) {
    const auto is_it = [&](std::size_t i) {
      return scene.tags[i].id == report.id &&
             length(middle_of(truth[i].corners) - middle_of(report.corners)) <
                 side_of(truth[i].corners) / 4;
    };
    std::size_t i = 0;
    while (i < all.size() && !is_it(i)) ++i;
    if (i == all.size() || all[i].found) {
      ++view.wrong;
    } else {
      all[i] = measure(report, truth[i].corners, scene.tags[i], scene.camera);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].tag = i;
    if (truth[i].visible > kSeen && is_inside(scene.tags[i], scene)) view.tags.push_back(all[i]);
  }
  return view;
}

void Tally::add(const View& view) {
  wrong += view.wrong;
  for (const Sighting& sighting : view.tags) {
    ++tags;
    if (!sighting.found) continue;
    ++found;
    corner_errors_px.push_back(sighting.corner_error_px);
    if (sighting.distance_error_m) distance_errors_m.push_back(*sighting.distance_error_m);
    if (sighting.orientation_error_deg) {
      orientation_errors_deg.push_back(*sighting.orientation_error_deg);
    }
  }
}

std::optional<double> Tally::share_found() const {
  if (tags == 0) return std::nullopt;
  return static_cast<double>(found) / tags;
}

std::optional<double> quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], at - static_cast<double>(below));
}

std::optional<double> median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

std::optional<double> mean(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> magnitudes(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

}  // namespace tagmint::evaluate
