#include "search/turn_index.h"

#include <cassert>

#include "search/sieve_kernels.h"

namespace tagmint::codec {

TurnIndex::TurnIndex(int bits, int fine_bits, int coarse_bits, std::span<const Codeword> turns)
    : fine_bits_(fine_bits), coarse_bits_(coarse_bits), words_(turns.size()) {
  assert(0 <= coarse_bits && coarse_bits <= fine_bits && fine_bits <= bits && fine_bits <= 31);
  // Counting sort: starts_[c + 2] first counts cell c, then starts_[c + 1] says where its next
  // turn goes, and has in the end become the start of the cell behind it.
  starts_.resize((std::size_t{1} << fine_bits) + 2);
  for (const Codeword turn : turns) ++starts_[cell_of(turn) + 2];
  for (std::size_t c = 2; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  for (const Codeword turn : turns) words_[starts_[cell_of(turn) + 1]++] = turn;
  starts_.pop_back();
  if (bits - fine_bits > 32) return;
  uppers_.reserve(words_.size() + sieve_kernels::kPadding);
  for (const Codeword word : words_) {
    uppers_.push_back(static_cast<std::uint32_t>(word >> fine_bits));
  }
  uppers_.resize(words_.size() + sieve_kernels::kPadding);
}

std::vector<std::uint32_t> words_of_weight(int bits, int weight) {
  std::vector<std::uint32_t> words;
  if (weight == 0) return {0};
  const std::uint32_t end = std::uint32_t{1} << bits;
  for (std::uint32_t word = (std::uint32_t{1} << weight) - 1; word < end;) {
    words.push_back(word);
    // The next larger word with as many ones: the lowest run of ones gives its top one to the zero
    // above it, and the rest of the run goes to the bottom.
    const std::uint32_t lowest = word & -word;
    const std::uint32_t carried = word + lowest;
    word = carried | (((word ^ carried) / lowest) >> 2);
  }
  return words;
}

}  // namespace tagmint::codec
