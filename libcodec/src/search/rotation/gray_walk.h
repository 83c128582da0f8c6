#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// The words of a code in Gray-code order: each differs from the one before by one basis word.
class GrayWalk {
 public:
  explicit GrayWalk(std::span<const Codeword> basis)
      : basis_(basis), end_(std::uint64_t{1} << basis.size()) {}

  /// Puts the next words, at most `count`, into `words`, and none at the end.
  void next(std::size_t count, std::vector<Codeword>& words) {
    words.clear();
    while (words.size() < count && step_ < end_) {
      words.push_back(word_);
      if (++step_ < end_) word_ ^= basis_[static_cast<std::size_t>(std::countr_zero(step_))];
    }
  }

 private:
  std::span<const Codeword> basis_;
  std::uint64_t end_;
  std::uint64_t step_ = 0;
  Codeword word_ = 0;
};

}  // namespace tagmint::codec
