#include "cell_index.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// A filter has at least so many words that there are at most so many entries to each: 11 to 21
/// bits an entry, of which up to one in four is set.
constexpr std::size_t kEntriesPerFilterWord = 6;

}  // namespace

CellIndex::CellIndex(std::span<const Codeword> codewords, int bits, int turns,
                     const CellMask& cells)
    : cells_(cells) {
  assert(turns == 1 || turns == 4);
  const std::size_t count = codewords.size() * static_cast<std::size_t>(turns);
  // As many buckets as there are values of the cells, or one to two for each entry.
  const int most_bucket_bits = static_cast<int>(std::bit_width(count));
  const int key_bits = static_cast<int>(std::bit_width(cells.mask));
  hashed_ = key_bits > most_bucket_bits;
  const int bucket_bits = std::max(1, std::min(key_bits, most_bucket_bits));
  bucket_shift_ = kMaxBits - bucket_bits;

  // The places of all turns of all codewords, in that order.
  std::vector<Place> places;
  places.reserve(count);
  for (Codeword word : codewords) {
    for (int turn = 0; turn < turns; ++turn, word = rotate_quarter(word, bits)) {
      places.push_back(place(word));
    }
  }

  // Counting sort of the entries by bucket.
  begins_.assign((std::size_t{1} << bucket_bits) + 1, 0);
  for (const Place one : places) ++begins_[(one >> bucket_shift_) + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  entries_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = turns == 4 ? i : 4 * i;
    entries_[next[places[i] >> bucket_shift_]++] = static_cast<Entry>(entry);
  }

  if (!hashed_) {
    filter_.assign(2, ~Codeword{0});
    return;
  }
  const int filter_bits =
      std::max(1, static_cast<int>(std::bit_width((count - 1) / kEntriesPerFilterWord)));
  filter_shift_ = kMaxBits - filter_bits;
  filter_.assign(std::size_t{1} << filter_bits, 0);
  for (const Place one : places) {
    filter_[one >> filter_shift_] |= Codeword{1} << first_bit(one) |
                                     Codeword{1} << second_bit(one) | Codeword{1} << third_bit(one);
  }
}

}  // namespace tagmint::codec
