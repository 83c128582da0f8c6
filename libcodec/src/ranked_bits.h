#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tagmint::codec {

/// A row of bits that counts the ones before a place and finds the n-th one: a running count every
/// 512 bits, and at most eight words looked at after it. 1/16 more memory than the bits.
class RankedBits {
 public:
  RankedBits() = default;

  /// Bit i is bit i % 64 of words[i / 64]; fewer than 2^32 ones.
  explicit RankedBits(std::vector<std::uint64_t> words) : words_(std::move(words)) {
    counts_.reserve(words_.size() / kWordsABlock + 1);
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (i % kWordsABlock == 0) counts_.push_back(static_cast<std::uint32_t>(ones_));
      ones_ += std::popcount(words_[i]);
    }
  }

  std::size_t ones() const { return ones_; }

  bool test(std::size_t place) const { return ((words_[place / 64] >> (place % 64)) & 1) != 0; }

  /// Ones before `place`, which is below the number of bits.
  std::size_t rank(std::size_t place) const {
    const std::size_t word = place / 64;
    const std::size_t block = word / kWordsABlock;
    std::size_t ones = counts_[block];
    for (std::size_t i = block * kWordsABlock; i < word; ++i) ones += std::popcount(words_[i]);
    return ones + std::popcount(words_[word] & ((std::uint64_t{1} << (place % 64)) - 1));
  }

  /// Place of the one that has `number` ones before it; number < ones().
  std::size_t select(std::size_t number) const {
    const auto after = std::upper_bound(counts_.begin(), counts_.end(), number);
    const auto block = static_cast<std::size_t>(after - counts_.begin()) - 1;
    std::size_t left = number - counts_[block];
    std::size_t word = block * kWordsABlock;
    for (std::size_t ones; (ones = std::popcount(words_[word])) <= left; ++word) left -= ones;
    std::uint64_t rest = words_[word];
    for (; left > 0; --left) rest &= rest - 1;
    return 64 * word + std::countr_zero(rest);
  }

  /// Calls visit(place) for the ones with numbers begin .. end - 1, end <= ones(); none where begin
  /// is not below end.
  template <typename Visit>
  void visit_ones(std::size_t begin, std::size_t end, const Visit& visit) const {
    if (begin >= end) return;
    const std::size_t first = select(begin);
    std::size_t left = end - begin;
    std::size_t word = first / 64;
    std::uint64_t rest = words_[word] >> (first % 64) << (first % 64);
    for (; left > 0; --left) {
      while (rest == 0) rest = words_[++word];
      visit(64 * word + std::countr_zero(rest));
      rest &= rest - 1;
    }
  }

  /// Bytes of the bits and counts for so many bits, a multiple of 64.
  static std::size_t bytes(std::size_t bits) {
    const std::size_t words = bits / 64;
    return 8 * words + 4 * ((words + kWordsABlock - 1) / kWordsABlock);
  }

 private:
  static constexpr std::size_t kWordsABlock = 8;

  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> counts_;  // ones before each block of words
  std::size_t ones_ = 0;
};

}  // namespace tagmint::codec
