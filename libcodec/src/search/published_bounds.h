#pragma once

#include <optional>

#include "search/word_bounds.h"

namespace tagmint::codec {

/// An upper bound of A(n, d), the number of words of n bits at pairwise distance d, for even d,
/// that was proven by semidefinite programming and is smaller than all that is computed here;
/// nothing where no such bound is known to us.
///   source  [GijswijtMittelmannSchrijver2012], abstract
std::optional<WideCount> published_bound(int bits, int even_distance);

}  // namespace tagmint::codec
