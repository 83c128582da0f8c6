#include "search/greedy.h"

#include <algorithm>

#include "tagmint/codec/rotation.h"

namespace tagmint::codec {

Round choose_greedily(const SiftedWords& sifted, int bits, int min_hamming, std::uint64_t first,
                      std::uint64_t count, std::size_t max_codes) {
  Round round{.judged = count, .taken = {}, .overlapping = 0};
  for (const auto& [index, word] : sifted.kept) {
    const bool overlaps =
        std::any_of(round.taken.begin(), round.taken.end(), [&, word = word](Codeword code) {
          return rotation_distance(word, code, bits) < min_hamming;
        });
    if (overlaps) {
      ++round.overlapping;
      continue;
    }
    round.taken.push_back(word);
    if (round.taken.size() == max_codes) {
      round.judged = index - first + 1;
      break;
    }
  }
  return round;
}

}  // namespace tagmint::codec
