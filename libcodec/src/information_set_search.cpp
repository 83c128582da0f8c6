#include "information_set_search.h"

#include <cassert>

namespace tagmint::codec {
namespace {

/// Sums of the kernel are listed while the list is no longer: what fits in the nearest cache beside
/// the tables.
constexpr std::size_t kShortList = 2048;

/// Lists are filled up to whole vectors of so many words, which saves the scan a slow end.
constexpr std::size_t kVectorWords = 8;

/// Adds to `list` the sums of `start` and at most `errors` of the columns from `first` on, without
/// `start` itself.
void add_sums(std::span<const Codeword> columns, Codeword start, int errors,
              std::vector<Codeword>& list) {
  if (errors == 0) return;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    list.push_back(start ^ columns[i]);
    add_sums(columns.subspan(i + 1), start ^ columns[i], errors - 1, list);
  }
}

/// What is left of a word when the sum that agrees with it in the block is taken away.
LinearMap rest_map(const InformationBlock& block, int bits) {
  std::vector<Codeword> columns(static_cast<std::size_t>(bits));
  for (std::size_t bit = 0; bit < columns.size(); ++bit) columns[bit] = Codeword{1} << bit;
  for (std::size_t i = 0; i < block.positions.size(); ++i) {
    columns[static_cast<std::size_t>(block.positions[i])] ^= block.columns[i];
  }
  return LinearMap(columns);
}

}  // namespace

InformationSetSearch::Block::Block(const BlockSearch& search, std::span<const Codeword> shifts,
                                   int bits)
    : rest(rest_map(search.block, bits)), kernel(search.block.kernel) {
  for (const Codeword shift : shifts) {
    list.push_back(rest(shift));
    add_sums(search.block.columns, list.back(), search.errors, list);
  }
  while (!kernel.empty() && 2 * list.size() <= kShortList) {
    const std::size_t half = list.size();
    for (std::size_t i = 0; i < half; ++i) list.push_back(list[i] ^ kernel.back());
    kernel.pop_back();
  }
  while (list.size() % kVectorWords != 0) list.push_back(list.front());
  list.shrink_to_fit();
}

InformationSetSearch::InformationSetSearch(std::span<const Codeword> basis,
                                           std::span<const Codeword> shifts, int bits, int radius)
    : bits_(bits), radius_(radius) {
  assert(!shifts.empty() && radius >= 0 && radius <= bits);
  for (const BlockSearch& search : plan_search(basis, bits, shifts.size(), radius)) {
    blocks_.emplace_back(search, shifts, bits);
  }
}

std::uint64_t InformationSetSearch::words_compared() const {
  std::uint64_t words = 0;
  for (const Block& block : blocks_)
    words += std::uint64_t{block.list.size()} << block.kernel.size();
  return words;
}

std::size_t InformationSetSearch::table_bytes() const {
  constexpr std::size_t kMapBytes = 256 * sizeof(Codeword);  // for each byte of a word
  std::size_t bytes = 0;
  for (const Block& block : blocks_) {
    bytes += block.list.size() * sizeof(Codeword) +
             (static_cast<std::size_t>(bits_) + 7) / 8 * kMapBytes;
  }
  return bytes;
}

}  // namespace tagmint::codec
