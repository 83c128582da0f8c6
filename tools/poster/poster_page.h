#pragma once

#include <cstddef>
#include <vector>

#include "draw/canvas.h"
#include "poster/poster_plan.h"

namespace tagmint::poster {

/// Distance of the middle of a cross from the printed part or the poster's rim, and half its size.
inline constexpr double kCrossDistanceMm = 3.0;
inline constexpr double kCrossArmMm = 2.0;

/// The crosses of a page, poster coordinates: where it meets its neighbours. Pages that meet have
/// the same ones, all of them outside what is seen in the end: at the two ends of each upright
/// joint above and below the row, at the two ends of each lying joint left and right of the poster.
std::vector<draw::PathPoint> crosses(const PosterPlan& plan, const PosterPage& page);

/// The black cells of a tag that a page shows, cut off at the page's part: a path on the page in
/// mm.
draw::Path black_on_page(const PosterPlan& plan, const PosterPage& page, const PosterTag& tag);

/// Draws a page: its part of the poster, lines to cut along, crosses, and in the lower margin which
/// page it is. Nothing but the tag is drawn inside the part of the poster that the page shows.
void draw_poster_page(draw::Canvas& canvas, const PosterPlan& plan, std::size_t index);

}  // namespace tagmint::poster
