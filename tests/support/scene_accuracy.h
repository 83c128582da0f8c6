#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "scene/render.h"
#include "scene/scene.h"
#include "tagmint/detect/detection.h"

namespace tagmint::test {

/// How detections compare with the truth of a scene in which every tag occurs once.
struct Accuracy {
  int found = 0;                           ///< tags of the scene with a detection of their id
  int wrong = 0;                           ///< detections that no tag of the scene explains
  std::vector<double> corner_errors_px{};  ///< of the found tags, ascending

  double median_px() const {
    return corner_errors_px.empty() ? 1e9 : corner_errors_px[corner_errors_px.size() / 2];
  }
};

inline void add_accuracy(const scene::Scene& scene, std::span<const scene::TagTruth> truth,
                         std::span<const detect::Detection> detections, Accuracy& accuracy) {
  for (const detect::Detection& detection : detections) {
    bool explained = false;
    for (std::size_t i = 0; i < truth.size() && !explained; ++i) {
      const scene::SceneTag& tag = scene.tags[i];
      if (tag.id != detection.id || tag.family->name() != detection.family->name()) continue;
      // Elsewhere, it is a false one that happens to have the id of a real one.
      const double nearby = 10;
      if (length(detection.corners[0] - truth[i].corners[0]) > nearby) continue;
      explained = true;
      for (std::size_t k = 0; k < 4; ++k) {
        accuracy.corner_errors_px.push_back(length(detection.corners[k] - truth[i].corners[k]));
      }
    }
    explained ? ++accuracy.found : ++accuracy.wrong;
  }
  std::sort(accuracy.corner_errors_px.begin(), accuracy.corner_errors_px.end());
}

}  // namespace tagmint::test
