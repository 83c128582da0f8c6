#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernels/outline_kernels.h"
#include "kernels/start_kernels.h"
#include "tagmint/detect/geometry.h"
#include "tracker/t4_track.h"

namespace tagmint::detect {

/// Stage T5: a shape -> the four corners of the quad that it may be. Extreme points do it, without
/// any line fit: the point farthest from the middle is a corner, the one farthest from that is
/// another, and the farthest on both sides of the line between them are the others. Then the shape
/// must be that quad: in its area, and in that no point of its outline lies far from the sides. No
/// gray value is read yet.
struct CornerOptions {
  double min_side_px = 5;  ///< quads with a smaller mean side are refused, working px
};

/// Why a shape is no quad.
enum class CornerOutcome {
  TooSmall,    ///< lower, narrower or of less area than the smallest side asks for
  NoCorners,   ///< no four extreme points
  WrongArea,   ///< the quad of the corners does not fill what the shape fills
  NotStraight  ///< a point of the outline is far from the sides
};

/// The outline's points, kept from one shape to the next.
struct OutlineScratch {
  std::vector<float> x;
  std::vector<float> y;
};

/// Corners counter-clockwise as seen, working px; or why not.
///   cost     a pass over at most 2 kMaxOutlineRows points for each of at most eight steps
struct CornerResult {
  std::optional<Corners> corners;
  CornerOutcome refused = CornerOutcome::NoCorners;  ///< when there are none
};
CornerResult find_corners(const Shape& shape, const CornerOptions& options,
                          OutlineScratch& scratch);

/// Rows of a shape that are looked at; of higher ones every second, third, ... row.
inline constexpr int kMaxOutlineRows = 256;

}  // namespace tagmint::detect
