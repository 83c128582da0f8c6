#pragma once

#include <cstddef>
#include <vector>

#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// Two tags of a family that look much alike.
struct TAGMINT_API NearPair {
  TagId first = 0;
  TagId second = 0;  ///< above `first`
  int distance = 0;  ///< least of the four rotations
  int turns = 0;     ///< quarter turns of `second`, as rotate() makes them, that bring it so near
  friend bool operator==(const NearPair&, const NearPair&) = default;
};

/// The pairs of different tags that are at most `within` bits apart in some rotation, ordered by
/// their first and then their second id.
///   family   with listed codewords
///   most     no more than so many pairs: the first ones
///   threads  0 = all cores; the result does not depend on it
///   cost     O(codes^2) where there are fewer than `most`, some 2 ns a pair and thread; else it
///            ends with the rows that hold them
TAGMINT_API std::vector<NearPair> near_pairs(const Family& family, int within, std::size_t most,
                                             int threads = 0);

}  // namespace tagmint::codec
