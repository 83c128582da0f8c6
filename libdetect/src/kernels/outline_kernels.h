#pragma once

#include <cstddef>
#include <cstdint>

namespace tagmint::detect {

/// Points of an outline, px; kOutlinePadding more may be read. For farthest_...() copies of the
/// last point follow up to the next multiple of that.
struct OutlineView {
  const float* x = nullptr;
  const float* y = nullptr;
  int size = 0;  ///< at least 1
};
inline constexpr int kOutlinePadding = 16;

/// The outline's points farthest to the left and to the right of a line as one walks along it, with
/// y down; distances are in units of the step's length.
struct FarthestBothSides {
  int right = 0;  ///< index; the first of several
  int left = 0;
  float right_distance = 0;  ///< below 0 where all points are on the left
  float left_distance = 0;
};

/// Index of the point farthest from (px, py), the first of several.
///   cost     one pass, a vector at a time
int farthest_point(const OutlineView& outline, float px, float py);

/// Largest cross products with the step (ex, ey) from (ax, ay) on both sides.
///   cost     one pass
FarthestBothSides farthest_both_sides(const OutlineView& outline, float ax, float ay, float ex,
                                      float ey);

/// Whether the cross products of all points with the step (ex, ey) from (ax, ay) are at most `most`
/// in magnitude. Points may follow that are none of the outline.
///   cost     one pass, left at the first vector with a point too far
bool all_near_line(const OutlineView& outline, float ax, float ay, float ex, float ey, float most);

namespace scalar {

/// The same, a point at a time.
int farthest_point(const OutlineView& outline, float px, float py);
FarthestBothSides farthest_both_sides(const OutlineView& outline, float ax, float ay, float ex,
                                      float ey);
bool all_near_line(const OutlineView& outline, float ax, float ay, float ex, float ey, float most);

}  // namespace scalar

}  // namespace tagmint::detect
