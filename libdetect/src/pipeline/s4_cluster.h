#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/stage_types.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/image_view.h"

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

/// A boundary point before its cluster is complete; twice its coordinates are whole numbers.
struct PendingPoint {
  std::uint32_t cluster = 0;
  std::int32_t twice_x = 0;
  std::int32_t twice_y = 0;
  std::int16_t gx = 0;
  std::int16_t gy = 0;
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
  std::vector<std::uint64_t> keys;    ///< pair of components by cluster, in order of appearance
  std::vector<std::size_t> counts;    ///< points by cluster
  std::vector<std::size_t> targets;   ///< where the next point of each cluster goes
  std::vector<PendingPoint> pending;  ///< all points in the order of the scan
};

/// Finds all boundary points and groups them. A pixel is compared with its neighbours right, below
/// left, below and below right, so each pair of 8-neighbours is looked at once; where one is black
/// and the other white, their midpoint is a boundary point of that pair of components.
///   three_valued, labels   results of stages 2 and 3, same size
///   out      clusters in the order of their first point, points in the order of the scan
///   stats    boundary_points and clusters are added to
///   cost     O(pixels + boundary points); plain areas are passed over eight pixels at a time
void cluster(ImageView three_valued, const Labels& labels, const ClusterOptions& options,
             ClusterScratch& scratch, Clusters& out, DetectStats& stats);

}  // namespace tagmint::detect
