#pragma once

#include <vector>

#include "poster/poster_plan.h"
#include "tagmint/detect/image.h"

namespace tagmint::test {

/// The pages of a poster put together as its map says: each laid over those before it, cut along
/// its upper and left side, and the rim cut last.
///   pages     pictures of the poster's pages, without the map
///   px_a_mm   pixels a mm, such that the plan's places are whole pixels
detect::Image glued_poster(const poster::PosterPlan& plan, const std::vector<detect::Image>& pages,
                           double px_a_mm);

}  // namespace tagmint::test
