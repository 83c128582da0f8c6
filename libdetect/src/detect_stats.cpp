#include "tagmint/detect/detect_stats.h"

namespace tagmint::detect {

std::string_view name_of(Stage stage) {
  constexpr std::array<std::string_view, kStages> names = {
      "preprocess",   "threshold",   "segment",   "cluster",    "fit_quads",
      "refine_edges", "noise_floor", "bitmap",    "starts",     "track",
      "fit_edges",    "decode",      "reconcile", "refine_tags"};
  return names[static_cast<std::size_t>(stage)];
}

bool belongs_to(Stage stage, Algorithm algorithm) {
  switch (stage) {
    case Stage::Preprocess:
    case Stage::Decode:
    case Stage::Reconcile:
    case Stage::RefineTags:
      return true;
    case Stage::Threshold:
    case Stage::Segment:
    case Stage::Cluster:
    case Stage::FitQuads:
    case Stage::RefineEdges:
      return algorithm == Algorithm::Paper;
    case Stage::NoiseFloor:
    case Stage::Bitmap:
    case Stage::Starts:
    case Stage::Track:
    case Stage::FitEdges:
      return algorithm == Algorithm::Tracker;
  }
  return false;
}

DetectStats& DetectStats::operator+=(const DetectStats& other) {
  components += other.components;
  boundary_points += other.boundary_points;
  clusters += other.clusters;
  clusters_too_large += other.clusters_too_large;
  clusters_open += other.clusters_open;
  clusters_too_small += other.clusters_too_small;
  wrong_border_colour += other.wrong_border_colour;
  starts += other.starts;
  starts_covered += other.starts_covered;
  starts_visited += other.starts_visited;
  starts_not_convex += other.starts_not_convex;
  shapes += other.shapes;
  shapes_too_small += other.shapes_too_small;
  quads_known += other.quads_known;
  no_corners += other.no_corners;
  bad_fit += other.bad_fit;
  bad_shape += other.bad_shape;
  quads += other.quads;
  outside_image += other.outside_image;
  no_contrast += other.no_contrast;
  no_codeword += other.no_codeword;
  low_margin += other.low_margin;
  duplicates += other.duplicates;
  detections += other.detections;
  refined_tags += other.refined_tags;
  for (int i = 0; i < kStages; ++i) stage_ms[i] += other.stage_ms[i];
  return *this;
}

}  // namespace tagmint::detect
