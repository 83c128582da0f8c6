#pragma once

#include <array>
#include <cstdint>

namespace tagmint::detect {

/// Scan lines across one side of a quad, at most.
inline constexpr int kMaxEdgeScans = 32;
/// Pixels of a scan line.
inline constexpr int kScanPixels = 8;
/// Places on a scan line are counted in this part of a pixel.
inline constexpr int kParts = 256;
/// The largest `along` of a scan line; that of longer sides is counted in larger steps.
inline constexpr int kMaxAlong = 511;

/// What the scan lines of a side read, by pixel and then by scan line, and where the side was
/// expected. Entries from `count` to the next multiple of 16 are read too; they take no part.
struct EdgeScans {
  int count = 0;
  /// Pixel 0 is the innermost one of a scan line.
  alignas(64) std::array<std::array<std::uint8_t, kMaxEdgeScans>, kScanPixels> gray{};
  alignas(64) std::array<std::int32_t, kMaxEdgeScans> along{};  ///< -kMaxAlong .. kMaxAlong
  /// Place of the given side, in parts of a pixel from the middle of pixel 0.
  alignas(64) std::array<std::int32_t, kMaxEdgeScans> expected{};
};

/// Points of an edge: for each scan line with one, how far outwards of the given side it is, in
/// parts of a pixel.
struct EdgePoints {
  alignas(64) std::array<std::int32_t, kMaxEdgeScans> off;
  alignas(64) std::array<std::int32_t, kMaxEdgeScans> counts;  ///< 1 where there is a point, else 0
};

/// Sums over the points that count, for a regression of `off` on `along`. Whole numbers, so that
/// their order does not matter.
struct EdgeSums {
  std::int32_t n = 0;
  std::int32_t along = 0;
  std::int32_t off = 0;
  std::int32_t along_along = 0;
  std::int32_t along_off = 0;
  std::int32_t off_off = 0;
};

/// Twice the gray level half-way between the means of the darkest and of the brightest pixels of
/// the scan lines; count > 0.
int twice_middle_level(const EdgeScans& scans);

/// Where each scan line passes the level from dark to bright going outwards, nearest to where the
/// side was expected, the first of two at the same distance. A crossing between two pixels lies
/// where the straight line between their gray values has the level.
void find_edge_points(const EdgeScans& scans, int twice_level, EdgePoints& points);

EdgeSums sum_edge_points(const EdgeScans& scans, const EdgePoints& points);

/// Points farther than `limit` parts from off = at_zero + slope * along count no more.
void drop_far_points(const EdgeScans& scans, float at_zero, float slope, float limit,
                     EdgePoints& points);

namespace scalar {

/// The same, a scan line at a time.
int twice_middle_level(const EdgeScans& scans);
void find_edge_points(const EdgeScans& scans, int twice_level, EdgePoints& points);
EdgeSums sum_edge_points(const EdgeScans& scans, const EdgePoints& points);
void drop_far_points(const EdgeScans& scans, float at_zero, float slope, float limit,
                     EdgePoints& points);

}  // namespace scalar

}  // namespace tagmint::detect
