#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/search/bit_permutation.h"

namespace tagmint::codec {

/// How the tree of all words (OpenWordTree) sees a word. The four cells that a quarter turn moves
/// onto each other are an *orbit*; the tree decides one orbit a level, so the four bits of an orbit
/// lie side by side, and the three orbits of the leaves at the low end:
///
///     [ centre? | orbit q-1 | ... | orbit 4 | orbit 3 | orbits 2, 1, 0 ]
///        0 or 1      4 bits            4         4          12 bits
///
/// The four turns of a word are one tag, so that one of them is enough. With the quarter blocks
/// a b c d, a half turn exchanges a with c and b with d, and a quarter turn lets one of the two
/// pairs come in its present order and the other one reversed: one of the turns has a <= c and
/// b <= d. Blocks are compared orbit by orbit from the top, as the tree goes.
class TreeOrder {
 public:
  static constexpr int kLeafOrbits = 3;
  static constexpr int kLeafBits = 4 * kLeafOrbits;
  /// Fewest bits of a word: three orbits for the leaves and one to decide.
  static constexpr int kLeastBits = kLeafBits + 4;

  /// bits >= kLeastBits, bits % 4 is 0 or 1.
  explicit TreeOrder(int bits);

  int bits() const { return bits_; }
  /// Orbits that the tree decides above its leaves.
  int levels() const { return bits_ / 4 - kLeafOrbits; }
  bool has_centre() const { return bits_ % 4 == 1; }

  Codeword to_tree(Codeword codeword) const { return to_tree_(codeword); }
  Codeword to_codeword(Codeword tree_word) const { return to_codeword_(tree_word); }

  /// Whether the pairs of blocks are still equal on the orbits decided so far.
  struct Ties {
    bool a_c = true;
    bool b_d = true;
  };
  /// The ties after one more orbit with the four bits `nibble` has been decided.
  static Ties after(Ties ties, unsigned nibble) {
    return {ties.a_c && bit_a(nibble) == bit_c(nibble), ties.b_d && bit_b(nibble) == bit_d(nibble)};
  }
  /// Whether that orbit breaks a <= c or b <= d, so that another turn of the word stands for the
  /// tag.
  static bool breaks_order(Ties ties, unsigned nibble) {
    return (ties.a_c && bit_a(nibble) > bit_c(nibble)) ||
           (ties.b_d && bit_b(nibble) > bit_d(nibble));
  }

 private:
  static unsigned bit_a(unsigned nibble) { return nibble >> 3 & 1; }
  static unsigned bit_b(unsigned nibble) { return nibble >> 2 & 1; }
  static unsigned bit_c(unsigned nibble) { return nibble >> 1 & 1; }
  static unsigned bit_d(unsigned nibble) { return nibble & 1; }

  int bits_;
  BitPermutation to_tree_;
  BitPermutation to_codeword_;
};

}  // namespace tagmint::codec
