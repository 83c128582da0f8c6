#pragma once

#include <bit>
#include <cstddef>
#include <vector>

#include "echelon.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// The words that a linear map takes to 0, found by elimination from the images of single words.
class KernelFinder {
 public:
  /// True when the image of `word`, or of its sum with some words given before, is 0; `word` then
  /// becomes that sum. The sums found so span the kernel on the span of all words given.
  bool add(Codeword& word, Codeword image) {
    const Echelon::Sum sum = images_.reduce(image);
    for (Codeword left = sum.combination; left != 0; left &= left - 1) {
      word ^= words_[static_cast<std::size_t>(std::countr_zero(left))];
    }
    if (sum.rest == 0) return true;
    images_.take(sum.rest);
    words_.push_back(word);
    return false;
  }

 private:
  Echelon images_;
  std::vector<Codeword> words_;  // whose images were taken
};

}  // namespace tagmint::codec
