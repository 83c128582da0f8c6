#include "search/tree_order.h"

#include <cassert>

namespace tagmint::codec {
namespace {

/// From codewords [a | b | c | d | centre] to tree words.
BitPermutation to_tree_permutation(int bits) {
  assert(bits >= TreeOrder::kLeastBits && bits % 4 <= 1);
  const int centre_bits = bits % 4;
  const int orbits = bits / 4;
  std::vector<int> target(bits);
  if (centre_bits == 1) target[0] = bits - 1;
  for (int quarter = 0; quarter < 4; ++quarter) {  // from d, the least significant block, to a
    for (int orbit = 0; orbit < orbits; ++orbit) {
      target[centre_bits + quarter * orbits + orbit] = 4 * orbit + quarter;
    }
  }
  return BitPermutation(target);
}

}  // namespace

TreeOrder::TreeOrder(int bits)
    : bits_(bits), to_tree_(to_tree_permutation(bits)), to_codeword_(to_tree_.inverse()) {}

}  // namespace tagmint::codec
