#pragma once

#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::test {

/// Where a picture of a page has the corners of a border square: each side is found from how much
/// is black across it, half a cell from its two ends, and the sides are cut with each other.
///   px_a_mm    pixels a mm
///   near_mm    where the corners ought to be, in mm on the page; right to less than 0.4 cells
///   cell_mm    side of the tag's cells
///   reversed   white inside black (Layout::reversed_border())
///   returns    mm on the page, in the order of `near_mm`
detect::Corners measured_corners(detect::ImageView page, double px_a_mm,
                                 const detect::Corners& near_mm, double cell_mm, bool reversed);

}  // namespace tagmint::test
