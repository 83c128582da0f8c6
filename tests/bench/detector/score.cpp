#include "detector/score.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tagmint::bench {
namespace {

using detect::Corners;
using detect::Point;

Point middle_of(const Corners& c) { return 0.25 * (c[0] + c[1] + c[2] + c[3]); }
double side_of(const Corners& c) { return std::sqrt(std::abs(signed_area(c))); }

void measure(const Corners& found, const Corners& truth, Score& score) {
  const Point middle = middle_of(truth);
  for (std::size_t k = 0; k < 4; ++k) {
    const Point error = found[k] - truth[k];
    const Point outwards = truth[k] - middle;
    score.corner_errors_px.push_back(length(error));
    score.radial_errors_px.push_back(dot(error, outwards) / length(outwards));
  }
  score.size_errors.push_back(side_of(found) / side_of(truth) - 1);
}

}  // namespace

void judge(std::span<const FoundTag> reports, const Picture& picture, Score& score) {
  score.tags += static_cast<int>(picture.tags.size());
  std::vector<bool> seen(picture.tags.size(), false);
  for (const FoundTag& report : reports) {
    const auto is_it = [&](const TrueTag& tag) {
      return tag.id == report.id && tag.family == report.family &&
             length(middle_of(tag.corners) - middle_of(report.corners)) < side_of(tag.corners) / 4;
    };
    const auto at = std::find_if(picture.tags.begin(), picture.tags.end(), is_it);
    const auto i = static_cast<std::size_t>(at - picture.tags.begin());
    if (at == picture.tags.end() || seen[i]) {
      ++score.false_ids;
      continue;
    }
    seen[i] = true;
    ++score.found;
    measure(report.corners, at->corners, score);
  }
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

double trimmed_mean(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto cut = static_cast<std::ptrdiff_t>(values.size() / 10);
  const double sum = std::accumulate(values.begin() + cut, values.end() - cut, 0.0);
  return sum / static_cast<double>(std::ssize(values) - 2 * cut);
}

}  // namespace tagmint::bench
