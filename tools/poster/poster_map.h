#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"
#include "poster/poster_plan.h"

namespace tagmint::poster {

/// Sizes and pages of a poster, line by line: each tag's edge and outer side, the size with the
/// quiet zone, how many pages of which paper.
std::vector<std::string> poster_facts(const PosterPlan& plan);

/// Draws the page that goes before those of the poster, on the same paper as its first page: facts,
/// a map with every page's number, how to put them together, and a ruler.
void draw_poster_map(draw::Canvas& canvas, const PosterPlan& plan);

}  // namespace tagmint::poster
