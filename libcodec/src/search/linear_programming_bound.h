#pragma once

#include "search/word_bounds.h"

namespace tagmint::codec {

/// An upper bound of A(n, d), the number of words of n bits at pairwise distance d, for even d. The
/// numbers A_i of words at distance i of a word, averaged over the words, obey Delsarte's
/// inequalities
///     sum over i of A_i K_k(i) >= 0   for k = 0..n,   K_k = Krawtchouk's polynomial of degree k,
/// and A_i <= A(n, d, i); the largest sum of A_i that these allow is the bound. A linear program's
/// dual solution gives it, and any numbers in place of that solution would give a larger one, so
/// that rounding does no harm.
///   bits           1..65, at least the distance
///   even_distance  2, 4, ...
///   weights        of the same distance, for at least that many bits
///   cost           O(bits^3) operations usually, some 15 ms at 64 bits
///   source         [Delsarte1973]; [MacWilliamsSloane1977], chapter 17
WideCount linear_programming_bound(int bits, int even_distance,
                                   const ConstantWeightBounds& weights);

}  // namespace tagmint::codec
