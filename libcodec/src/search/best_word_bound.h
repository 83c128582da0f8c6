#pragma once

#include <string>

#include "search/word_bounds.h"

namespace tagmint::codec {

struct WordBound {
  WideCount words = 0;
  std::string source;  ///< as in SizeBound
};

/// The smallest upper bound of A(n, d), the number of words of n bits at pairwise distance d, that
/// we can compute or know of.
///   bits, distance, cost, source   as for upper_bound_of_tags()
WordBound best_word_bound(int bits, int distance);

}  // namespace tagmint::codec
