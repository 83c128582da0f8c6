#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tagmint/codec/export.h"
#include "tagmint/detect/detector_options.h"

namespace tagmint::detect {

/// The stages of both paths, in order. Preprocess, Decode and Reconcile belong to both.
enum class Stage {
  Preprocess,
  // Algorithm::Paper
  Threshold,
  Segment,
  Cluster,
  FitQuads,
  RefineEdges,
  // Algorithm::Tracker
  NoiseFloor,
  Bitmap,
  Starts,
  Track,  ///< following shapes, and their corners
  FitEdges,
  // Both
  Decode,
  Reconcile,
  RefineTags
};
inline constexpr int kStages = 14;
TAGMINT_API std::string_view name_of(Stage stage);
/// Whether an algorithm has the stage.
TAGMINT_API bool belongs_to(Stage stage, Algorithm algorithm);

/// What happened while one image went through, and why candidates fell away.
struct TAGMINT_API DetectStats {
  // Algorithm::Paper
  std::int64_t components = 0;  ///< black and white components
  std::int64_t boundary_points = 0;
  std::int64_t clusters = 0;            ///< boundaries that were large enough to look at
  std::int64_t clusters_too_large = 0;  ///< more points than any quad in their box could have
  std::int64_t clusters_open = 0;       ///< too few points to go round their box
  std::int64_t clusters_too_small = 0;  ///< bounding box too small or too thin
  std::int64_t wrong_border_colour =
      0;  ///< black inside white where no family wants it, or the reverse
  // Algorithm::Tracker
  std::int64_t starts = 0;             ///< runs that a shape may begin on
  std::int64_t starts_covered = 0;     ///< with black above after all
  std::int64_t starts_visited = 0;     ///< on a shape that was followed before
  std::int64_t starts_not_convex = 0;  ///< left early: no quad turns like that
  std::int64_t shapes = 0;             ///< followed to their lower end
  std::int64_t shapes_too_small = 0;   ///< too low, narrow or thin
  std::int64_t quads_known = 0;        ///< at half the size, found before at full size
  // Both
  std::int64_t no_corners = 0;     ///< no four corners: peaks of the line-fit error, extreme points
  std::int64_t bad_fit = 0;        ///< no four corners with straight sides
  std::int64_t bad_shape = 0;      ///< size, angles, winding or filling not those of a tag
  std::int64_t quads = 0;          ///< candidates that went on to decoding
  std::int64_t outside_image = 0;  ///< data cells, or most of the border ring, not in the picture
  std::int64_t no_contrast = 0;    ///< border not clearly darker (or lighter) than its surroundings
  std::int64_t no_codeword = 0;    ///< bits too far from every codeword
  std::int64_t low_margin = 0;     ///< below min_decision_margin
  std::int64_t duplicates = 0;     ///< same tag, or several families, in one place
  std::int64_t detections = 0;
  std::int64_t refined_tags = 0;  ///< detections whose corners the photometric step made truer
  std::array<double, kStages> stage_ms{};  ///< wall time by Stage

  DetectStats& operator+=(const DetectStats& other);
};

}  // namespace tagmint::detect
