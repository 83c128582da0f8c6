#pragma once

#include <bit>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// Words over GF(2) in echelon form: tells whether a word is a sum of those taken so far, and of
/// which.
class Echelon {
 public:
  /// A word as a sum of taken words and a rest that has none of their pivot bits.
  struct Sum {
    Codeword rest = 0;         ///< 0: the word is in the span. Equal for words of one coset
    Codeword combination = 0;  ///< bit i: the i-th taken word is part of the sum
  };

  /// `word` as such a sum; linear in `word`. Cost: O(taken words).
  Sum reduce(Codeword word) const {
    Sum sum{word, 0};
    for (const Row& row : rows_) {
      if ((sum.rest & row.pivot) == 0) continue;
      sum.rest ^= row.word;
      sum.combination ^= row.combination;
    }
    return sum;
  }

  /// Takes one more word; false, and nothing taken, where it is a sum of the others. At most 64
  /// words can be taken.
  bool take(Codeword word) {
    const Sum sum = reduce(word);
    if (sum.rest == 0) return false;
    const Codeword own = Codeword{1} << rows_.size();
    rows_.push_back({sum.rest, std::bit_floor(sum.rest), sum.combination ^ own});
    return true;
  }

  /// How many words were taken: the dimension of their span.
  int rank() const { return static_cast<int>(rows_.size()); }

 private:
  struct Row {
    Codeword word = 0;
    Codeword pivot = 0;        // one bit of `word` that no later row has
    Codeword combination = 0;  // the taken words whose sum `word` is
  };
  std::vector<Row> rows_;
};

}  // namespace tagmint::codec
