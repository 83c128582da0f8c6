#pragma once

#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// Area common to two convex quads, >= 0. Both in one winding, either one; zero when they only
/// touch.
///   cost     one polygon of at most eight corners cut by four lines
///   source   [SutherlandHodgman1974]
double overlap_area(const Corners& a, const Corners& b);

}  // namespace tagmint::detect
