#include "tagmint/codec/search/bit_permutation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace tagmint::codec {

BitPermutation::BitPermutation(std::span<const int> target)
    : target_(target.begin(), target.end()) {
  const int bits = size();
  if (bits > kMaxBits) {
    throw std::invalid_argument(
        fmt::format("a permutation of {} bits does not fit a word of {}", bits, kMaxBits));
  }
  std::vector<bool> taken(target_.size());
  for (const int place : target_) {
    if (place < 0 || place >= bits || taken[place]) {
      throw std::invalid_argument(
          fmt::format("a permutation of {} bits names each of 0..{} once", bits, bits - 1));
    }
    taken[place] = true;
  }
  tables_.resize((target_.size() + 7) / 8);
  for (int bit = 0; bit < bits; ++bit) {
    ByteTable& table = tables_[bit / 8];
    for (int byte = 0; byte < 256; ++byte) {
      if ((byte >> (bit % 8)) & 1) table[byte] |= Codeword{1} << target_[bit];
    }
  }
}

BitPermutation BitPermutation::inverse() const {
  std::vector<int> source(target_.size());
  for (int bit = 0; bit < size(); ++bit) source[target_[bit]] = bit;
  return BitPermutation(source);
}

BitPermutation reading_order(const Layout& layout) {
  const auto cells = layout.data_cells();
  const int bits = layout.bits();
  std::vector<int> by_place(bits);  // indices into cells, in reading order
  std::iota(by_place.begin(), by_place.end(), 0);
  std::sort(by_place.begin(), by_place.end(), [&](int a, int b) {
    return cells[a].y != cells[b].y ? cells[a].y < cells[b].y : cells[a].x < cells[b].x;
  });
  std::vector<int> target(bits);
  for (int place = 0; place < bits; ++place) target[bits - 1 - by_place[place]] = bits - 1 - place;
  return BitPermutation(target);
}

}  // namespace tagmint::codec
