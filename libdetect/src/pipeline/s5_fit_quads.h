#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "numerics/corner_search.h"
#include "numerics/line_fit.h"
#include "pipeline/stage_types.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage 5: a cluster of boundary points -> at most one quad [WangOlson2016, section III-D]. All
/// lengths are working pixels.
struct QuadOptions {
  int max_corner_candidates = 10;      ///< 4..kMaxCornerCandidates
  double max_line_fit_mse_px2 = 10.0;  ///< of each side
  double critical_angle_deg = 10.0;    ///< corners nearer to 0 or 180 degrees are refused
  double min_side_px = 4.0;            ///< square root of the smallest area
  bool normal_borders = true;          ///< some family has a black border inside white
  bool reversed_borders = true;        ///< some family has a white border inside black
};

/// Buffers that fit_quad() keeps from one cluster to the next; one for each thread.
struct QuadScratch {
  std::vector<std::uint64_t> order;  ///< angle and index of each point, packed for sorting
  std::vector<Point> points;         ///< by angle, without repetitions
  std::vector<double> weights;
  std::vector<LineMoments> moments;
  CornerScratch corners;
};

/// Sorts the points by angle about the centre of their bounding box, fits lines to windows of
/// neighbours, takes the places of largest error as candidate corners, and returns the four of them
/// whose sides fit best, as intersections of those sides.
///   cluster   boundary points of one pair of components, in any order
///   working   the picture of stage 1; its gradient magnitude weights the points
///   returns   corners in working pixels, counter-clockwise as seen; nothing when refused
///   stats     the counter of the reason is raised when refused, `quads` otherwise
///   cost      O(n log n) for n points, then at most C(max_corner_candidates, 4) combinations
std::optional<Quad> fit_quad(std::span<const BoundaryPoint> cluster, ImageView working,
                             const QuadOptions& options, QuadScratch& scratch, DetectStats& stats);

}  // namespace tagmint::detect
