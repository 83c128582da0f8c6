#pragma once

#include <string>

#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// How many tags a family can have, and which argument says so.
struct TAGMINT_API SizeBound {
  double tags = 0;     ///< whole number; beyond 2^53 rounded up to the next double
  std::string source;  ///< such as "linear programming" or "2 times Johnson at 23 bits"
};

/// The largest number of tags that any family of words of `bits` bits can have when all words in
/// all four turns are at least `distance` apart: a quarter of the smallest known bound of A(n, d),
/// the number of words at pairwise distance d. The bound is safe: rounding can make it larger, but
/// never too small.
///   bits      1..64
///   distance  at least 1
///   errors    std::invalid_argument outside these ranges
///   cost      some 30 ms at 64 bits
///   source    [MacWilliamsSloane1977], chapter 17: sphere packing, Singleton, Plotkin, Johnson,
///             A(n, 2r - 1) = A(n + 1, 2r), A(n, d) <= 2 A(n - 1, d); [Delsarte1973];
///             [GijswijtMittelmannSchrijver2012]
TAGMINT_API SizeBound upper_bound_of_tags(int bits, int distance);

}  // namespace tagmint::codec
