#include "search/walk_sieve.h"

#include <algorithm>

#include "search/odd_inverse.h"
#include "search/sieve_kernels.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {
namespace {

/// Codes of coarse cells are gathered until there are so many, then compared.
constexpr std::size_t kGatheredCodes = 256;

/// Longer stretches make no sieve faster.
constexpr std::uint64_t kLongestStretch = std::uint64_t{1} << 32;

std::uint64_t possible_stretch(int bits, std::uint64_t stretch) {
  // The words of a group are told apart by their upper bits, so none may come twice.
  const std::uint64_t most = std::min(kLongestStretch, low_mask(bits) + (bits < kMaxBits));
  return std::clamp<std::uint64_t>(stretch, 1, most);
}

/// Words begin, begin + 2^shift, ... among `count`.
std::uint64_t group_size(std::uint64_t begin, std::uint64_t count, int shift) {
  return ((count - 1 - begin) >> shift) + 1;
}

template <typename T>
void grow(std::vector<T>& buffer, std::size_t size) {
  if (buffer.size() < size) buffer.resize(std::max(size, 2 * buffer.size()));
}

std::vector<std::vector<std::uint32_t>> masks_by_weight(int bits, int greatest) {
  std::vector<std::vector<std::uint32_t>> masks;
  for (int weight = 0; weight <= std::min(bits, greatest); ++weight) {
    masks.push_back(words_of_weight(bits, weight));
  }
  return masks;
}

}  // namespace

WalkSieve::WalkSieve(int bits, int min_hamming, std::span<const Codeword> turns,
                     std::uint64_t stretch)
    : WalkSieve(bits, min_hamming, turns, stretch,
                plan_sieve(bits, min_hamming, turns.size(), possible_stretch(bits, stretch))) {}

WalkSieve::WalkSieve(int bits, int min_hamming, std::span<const Codeword> turns,
                     std::uint64_t stretch, const SievePlan& plan)
    : bits_(bits),
      min_hamming_(min_hamming),
      stretch_(possible_stretch(bits, stretch)),
      plan_(plan),
      index_(bits, plan.fine_bits, plan.coarse_bits, turns),
      fine_masks_(masks_by_weight(plan.fine_bits, std::min(plan.fine_weight, min_hamming - 1))),
      coarse_masks_(
          masks_by_weight(plan.coarse_bits, std::min(plan.coarse_weight, min_hamming - 1))) {}

std::vector<std::uint64_t> WalkSieve::open_words(Codeword first, std::uint64_t count,
                                                 Scratch& scratch) const {
  std::vector<std::uint64_t> open;
  constexpr std::uint64_t kInverse = inverse_of_odd(Walk::kStep);
  for (std::uint64_t begin = 0; begin < count; begin += std::min(stretch_, count - begin)) {
    const Codeword stretch_first = first + begin * Walk::kStep;
    const std::size_t known = open.size();
    sift_stretch(stretch_first, std::min(stretch_, count - begin), scratch, open);
    for (std::size_t i = known; i < open.size(); ++i) {
      open[i] = begin + (((open[i] - stretch_first) * kInverse) & low_mask(bits_));
    }
    std::sort(open.begin() + static_cast<std::ptrdiff_t>(known), open.end());
  }
  return open;
}

/// Adds the open words themselves to `open`, in no order; 1 <= count <= 2^bits.
void WalkSieve::sift_stretch(Codeword first, std::uint64_t count, Scratch& scratch,
                             std::vector<std::uint64_t>& open) const {
  const bool grouped = bits_ - plan_.fine_bits <= 32;
  const std::uint64_t groups = std::min(count, std::uint64_t{1} << plan_.fine_bits);
  const std::uint64_t coarse_groups = std::min(count, std::uint64_t{1} << plan_.coarse_bits);
  for (std::uint64_t coarse = 0; coarse < coarse_groups; ++coarse) {
    std::size_t left = 0;
    if (grouped) {
      for (std::uint64_t g = coarse; g < groups; g += std::uint64_t{1} << plan_.coarse_bits) {
        left = sift_group(first + g * Walk::kStep, group_size(g, count, plan_.fine_bits), scratch,
                          left);
      }
    } else {
      left = words_of_group(first + coarse * Walk::kStep,
                            group_size(coarse, count, plan_.coarse_bits), scratch, left);
    }
    left = sift_pool(index_.coarse_cell_of(first + coarse * Walk::kStep), scratch, left);
    open.insert(open.end(), scratch.words.data(), scratch.words.data() + left);
  }
}

/// Adds the `count` words of a coarse group to the pool.
std::size_t WalkSieve::words_of_group(Codeword first, std::uint64_t count, Scratch& scratch,
                                      std::size_t filled) const {
  grow(scratch.words, filled + count + sieve_kernels::kPadding);
  Codeword word = first;
  for (std::uint64_t i = 0; i < count; ++i, word += Walk::kStep << plan_.coarse_bits) {
    scratch.words[filled + i] = word & low_mask(bits_);
  }
  return filled + count;
}

/// Compares a group with its nearest codes and adds the words left to the pool.
std::size_t WalkSieve::sift_group(Codeword first, std::uint64_t count, Scratch& scratch,
                                  std::size_t filled) const {
  const int upper_bits = bits_ - plan_.fine_bits;
  grow(scratch.uppers, count + sieve_kernels::kPadding);
  grow(scratch.near_uppers, index_.turns().size() + sieve_kernels::kPadding);
  std::uint32_t* const uppers = scratch.uppers.data();
  sieve_kernels::fill_progression(static_cast<std::uint32_t>(first >> plan_.fine_bits),
                                  static_cast<std::uint32_t>(Walk::kStep), upper_bits, count,
                                  uppers);
  std::size_t left = count;
  for (std::size_t weight = 0; weight < fine_masks_.size() && left > 0; ++weight) {
    const std::vector<std::uint32_t>& masks = fine_masks_[weight];
    const std::size_t near =
        sieve_kernels::gather_cells(index_.starts(), index_.uppers(), index_.cell_of(first),
                                    masks.data(), masks.size(), scratch.near_uppers.data());
    left = sieve_kernels::keep_far(uppers, left, scratch.near_uppers.data(), near,
                                   min_hamming_ - static_cast<int>(weight));
  }
  grow(scratch.words, filled + left + sieve_kernels::kPadding);
  const Codeword low = first & low_mask(plan_.fine_bits);
  for (std::size_t i = 0; i < left; ++i) {
    scratch.words[filled + i] = Codeword{uppers[i]} << plan_.fine_bits | low;
  }
  return filled + left;
}

/// Compares the first `count` words of the pool with the codes of the nearest coarse cells, then
/// with all. Returns how many are left.
std::size_t WalkSieve::sift_pool(std::uint32_t coarse_cell, Scratch& scratch,
                                 std::size_t count) const {
  std::vector<Codeword>& near = scratch.near_words;
  for (const std::vector<std::uint32_t>& masks : coarse_masks_) {
    for (std::size_t m = 0; m < masks.size() && count > 0;) {
      near.clear();
      for (; m < masks.size() && near.size() < kGatheredCodes; ++m) {
        const std::span<const Codeword> cell = index_.coarse_cell(coarse_cell ^ masks[m]);
        near.insert(near.end(), cell.begin(), cell.end());
      }
      count = sieve_kernels::keep_far(scratch.words.data(), count, near.data(), near.size(),
                                      min_hamming_);
    }
  }
  return sieve_kernels::keep_far(scratch.words.data(), count, index_.turns().data(),
                                 index_.turns().size(), min_hamming_);
}

}  // namespace tagmint::codec
