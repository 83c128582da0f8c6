#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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
};

/// Pixels in a ring one pixel wide along the inside of a square of the given side: no component
/// with fewer can be the border of a tag of that size.
constexpr int smallest_ring_pixels(double side_px) {
  return side_px <= 1 ? 1 : static_cast<int>(4 * (side_px - 1));
}

/// Neighbouring pairs of pixels that all part the same two components: (x, y) and (x + dx, y + dy)
/// for x in [begin, end).
struct BoundaryStretch {
  std::uint32_t cluster = 0;
  std::int32_t begin = 0;
  std::int32_t end = 0;
  std::int32_t y = 0;
  std::int8_t dx = 0;
  std::int8_t dy = 0;
  std::int8_t to_white = 1;  ///< 1 when (x, y) is the black pixel of the pair, else -1
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
  std::vector<std::uint64_t> keys;         ///< pair of components by cluster, as first met
  std::vector<std::size_t> counts;         ///< points by cluster
  std::vector<std::size_t> targets;        ///< where the next point of each cluster goes
  std::vector<BoundaryStretch> stretches;  ///< all boundary points, as met
};

/// Finds all boundary points and groups them. Each pair of 8-neighbours is looked at once, as in
/// Fig. 4: a pixel and those right, below left, below and below right of it. Where one is black and
/// the other white, their midpoint is a boundary point of that pair of components. Pixels are not
/// visited one by one: two runs that touch share one pair of components, and so one look-up.
///   components   result of stage 3
///   out      clusters in the order in which their first runs meet, row by row from left to right
///   stats    boundary_points and clusters are added to
///   cost     O(runs + boundary points)
void cluster(const Components& components, const ClusterOptions& options, ClusterScratch& scratch,
             Clusters& out, DetectStats& stats);

}  // namespace tagmint::detect
