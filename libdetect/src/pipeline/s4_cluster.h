#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/outline.h"
#include "pipeline/stage_types.h"
#include "tagmint/detect/detect_stats.h"

namespace tagmint::detect {

/// Stage 4: boundary points, grouped by the two components that they separate [WangOlson2016,
/// section III-C, Fig. 4].
struct ClusterOptions {
  int min_points = 24;  ///< clusters with fewer boundary points are dropped
  /// Components with fewer pixels take part in no cluster. smallest_ring_pixels() gives the value
  /// below which no border ring can lie.
  int min_component_pixels = 0;
  /// Boundaries with another outline are dropped before their points are made; not given: none is.
  std::optional<OutlineLimits> limits{};
};

/// Pixels in a ring one pixel wide along the inside of a square of the given side: no component
/// with fewer can be the border of a tag of that size.
constexpr int smallest_ring_pixels(double side_px) {
  return side_px <= 1 ? 1 : static_cast<int>(4 * (side_px - 1));
}

/// A black and a white run that touch. All pairs of neighbouring pixels between them part the same
/// two components.
struct RunMeeting {
  std::uint32_t cluster = 0;
  std::uint32_t upper = 0;  ///< index of the run in row y
  std::uint32_t lower = 0;  ///< of the run in the row below; kBeside: the next run of the same row
  std::int32_t y = 0;
  static constexpr std::uint32_t kBeside = 0xffffffff;
};

/// Open-addressing hash table from a pair of components to the number of their cluster.
struct PairTable {
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t cluster = 0;
    bool used = false;
  };
  std::vector<Slot> slots;  ///< a power of two, at most half full
};

/// Buffers that cluster() keeps from one image to the next.
struct ClusterScratch {
  PairTable table;
  std::vector<std::uint64_t> keys;    ///< pair of components by cluster, as first met
  std::vector<OutlineSums> outlines;  ///< by cluster
  std::vector<std::size_t> targets;   ///< where the next point of each cluster goes
  std::vector<std::uint8_t> kept;     ///< by cluster: whether its points are made
  std::vector<RunMeeting> meetings;   ///< in the order of rows
};

/// Finds all boundary points and groups them. Each pair of 8-neighbours is looked at once, as in
/// Fig. 4: a pixel and those right, below left, below and below right of it. Where one is black and
/// the other white, their midpoint is a boundary point of that pair of components. Pixels are not
/// visited one by one: two runs that touch share one pair of components, and so one look-up. A
/// first pass over the runs adds up the outline of each boundary; points are made only of those
/// kept.
///   components   result of stage 3
///   out      clusters in the order in which their first runs meet, row by row from left to right
///   stats    boundary_points, clusters and the counters of refused outlines are added to
///   cost     O(runs + boundary points kept)
void cluster(const Components& components, const ClusterOptions& options, ClusterScratch& scratch,
             Clusters& out, DetectStats& stats);

}  // namespace tagmint::detect
