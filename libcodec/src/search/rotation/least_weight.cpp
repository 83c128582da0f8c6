#include "search/rotation/least_weight.h"

#include <algorithm>

#include "kernels/hamming_kernels.h"
#include "search/rotation/gray_walk.h"

namespace tagmint::codec {

int least_weight(std::span<const Codeword> basis) {
  constexpr std::size_t kStretch = std::size_t{1} << 12;
  int least = kMaxBits + 1;
  GrayWalk walk(basis);
  std::vector<Codeword> words;
  walk.next(1, words);  // 0
  for (walk.next(kStretch, words); !words.empty(); walk.next(kStretch, words)) {
    // Words lighter than the least so far are rare: look for the next such one.
    std::span<const Codeword> left = words;
    for (;;) {
      const std::size_t lighter = first_within(left, 0, least - 1);
      if (lighter == left.size()) break;
      least = std::popcount(left[lighter]);
      left = left.subspan(lighter + 1);
    }
  }
  return least;
}

}  // namespace tagmint::codec
