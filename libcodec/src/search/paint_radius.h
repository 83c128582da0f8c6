#pragma once

#include <cstddef>

namespace tagmint::codec {

/// The paint radius (OpenWordTree) that a model of the tree's work expects to be fastest: codes and
/// words are taken as random, so that the number of code turns with a given radius left at a leaf
/// is binomial, and so is the number of words that the painted balls leave open.
///   bits     of a word, at least TreeOrder::kLeastBits
///   radius   least distance - 1
///   turns    code turns
///   returns  0 .. radius
int best_paint_radius(int bits, int radius, std::size_t turns);

}  // namespace tagmint::codec
