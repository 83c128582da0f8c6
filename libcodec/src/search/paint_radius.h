#pragma once

#include <algorithm>
#include <cstddef>

#include "search/leaf_paint.h"

namespace tagmint::codec {

/// Which balls OpenWordTree paints on which rows of a twig; a matter of speed alone.
struct PaintPlan {
  int paint_radius = 0;  ///< balls of at least that radius are painted
  int deep_radius = 0;   ///< those from here on one row farther from the centre

  /// Rows with at most so many differing bits are painted with a ball of radius >= paint_radius:
  /// what is left of it there is the paint radius or more, or one less if the ball is deep.
  int depth(int radius) const {
    const int whole = radius - paint_radius + (radius >= deep_radius ? 1 : 0);
    return std::min({whole, radius, LeafPainter::kMostDepth});
  }
};

/// The plan that a model of the tree's work expects to be fastest: codes and words are taken as
/// random, so that the number of code turns with a given radius left at a twig is binomial, and so
/// is the number of words that the painted balls leave open.
///   bits           of a word, at least TreeOrder::kLeastBits
///   radius         least distance - 1
///   turns          code turns
///   paint_radius   of the plan, 0 .. radius
///   cost           some ten microseconds
PaintPlan best_paint_plan(int bits, int radius, std::size_t turns, int paint_radius);

/// The paint radius of the fastest of these plans: 0 .. radius.
int best_paint_radius(int bits, int radius, std::size_t turns);

}  // namespace tagmint::codec
