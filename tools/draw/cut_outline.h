#pragma once

#include "draw/path.h"
#include "draw/sheet_plan.h"

namespace tagmint::draw {

/// Width of cut lines and cut marks.
inline constexpr double kCutLineMm = 0.1;

/// Least gap that has room for the cut lines of two neighbours.
inline constexpr double kCutGapMm = 4 * kCutLineMm;

/// Where a tag is cut out, as the middle of a line of kCutLineMm that lies in the gap beside the
/// tag's slot (or, for a circle, around the tag within its slot) and touches no quiet zone.
///   gap_mm   between slots, at least kCutGapMm
Path cut_outline(const PlacedTag& tag, const codec::Layout& layout, CutShape shape, double gap_mm);

}  // namespace tagmint::draw
