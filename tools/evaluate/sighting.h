#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "evaluate/contender.h"
#include "scene/render.h"
#include "scene/scene.h"

namespace tagmint::evaluate {

/// One tag of a picture as a contender saw it.
struct Sighting {
  std::size_t tag = 0;  ///< its place in the scene
  bool found = false;
  double corner_error_px = 0;  ///< root of the mean square over the four corners
  // Of tags that are placed in space, from the reported corners by detect::estimate_pose():
  std::optional<double> distance_error_m = {};  ///< estimated less true distance from the camera
  std::optional<double> orientation_error_deg = {};  ///< of the turn that takes one to the other
};

/// One picture as a contender saw it.
struct View {
  std::vector<Sighting> tags;  ///< those of the scene that are wholly visible, in its order
  int wrong = 0;               ///< reports that are no tag of the scene in its place, or one twice
  std::optional<std::int64_t> candidates = {};
};

/// Judges what a contender reports. A report is right when its id is that of a tag of the scene
/// whose middle is within a quarter of a side. Tags that are cut or covered are not asked for.
View judge(std::span<const FoundTag> reports, const scene::Scene& scene,
           std::span<const scene::TagTruth> truth);

/// What the views of a contender over many pictures come to.
struct Tally {
  int tags = 0;
  int found = 0;
  int wrong = 0;
  std::vector<double> corner_errors_px;
  std::vector<double> distance_errors_m;  ///< signed
  std::vector<double> orientation_errors_deg;

  void add(const View& view);
  std::optional<double> share_found() const;
};

/// The value below which a share of the values lies, 0 <= share <= 1, between two of them by
/// linear interpolation; nothing when there are none.
std::optional<double> quantile(std::vector<double> values, double share);
std::optional<double> median(std::vector<double> values);
std::optional<double> mean(std::span<const double> values);
/// The values without their signs.
std::vector<double> magnitudes(std::vector<double> values);

}  // namespace tagmint::evaluate
