#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace tagmint::codec {

/// A floating point number of 113 significant bits: the answers of the linear programs here are as
/// large as 2^60 and come from sums that cancel to 1.
#ifdef __SIZEOF_FLOAT128__
__extension__ using Quad = __float128;
#else
using Quad = long double;
static_assert(std::numeric_limits<long double>::digits >= 113);
#endif

/// Find x >= 0 that makes gains * x largest while matrix * x <= limits.
struct LinearProgram {
  std::vector<std::vector<Quad>> matrix;  ///< rows x columns
  std::vector<Quad> limits;               ///< one a row, none negative: x = 0 is allowed
  std::vector<Quad> gains;                ///< one a column
};

/// The dual solution of a linear program by the simplex method: a price >= 0 for each row, such
/// that every column's prices add up to its gain at least and prices * limits is smallest. Prices
/// are as good as the arithmetic and at most 50 steps a row and column allow; whoever needs
/// certainty has to verify them.
///   cost    rows * columns multiplications a step; usually as many steps as rows
///   source  [Chvatal1983], chapters 2 (dictionaries), 3 (Bland's rule) and 5 (the dual solution)
std::vector<Quad> dual_prices(LinearProgram program);

}  // namespace tagmint::codec
