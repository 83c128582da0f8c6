#include "search/distance_filter.h"

#include <utility>

#define HWY_WANT_AVX3_DL  // the AVX-512 that counts bits
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/distance_filter.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Whether a word of the block is nearer than `min_hamming` to `word`: eight comparisons, in one to
/// four vectors. distance - min_hamming is negative for those, so the sign bits are gathered.
HWY_INLINE bool excludes(const TurnBlocks::Block& block, Codeword word, int min_hamming) {
  const hn::CappedTag<std::uint64_t, TurnBlocks::kWords> d;
  const hn::RebindToSigned<decltype(d)> signed_d;  // the cheaper comparison on most machines
  const auto needle = hn::Set(d, word);
  const auto radius = hn::Set(signed_d, min_hamming);
  auto signs = hn::Zero(signed_d);
  for (std::size_t lane = 0; lane < TurnBlocks::kWords; lane += hn::Lanes(d)) {
    const auto code = hn::Load(d, block.words.data() + lane);
    const auto distance = hn::BitCast(signed_d, hn::PopulationCount(hn::Xor(code, needle)));
    signs = hn::Or(signs, hn::Sub(distance, radius));
  }
  return !hn::AllFalse(signed_d, hn::Lt(signs, hn::Zero(signed_d)));
}

std::size_t keep_distant_vector(const Codeword* words, std::size_t count, TurnBlocks::Block* blocks,
                                std::size_t full, std::size_t total, int min_hamming,
                                std::uint32_t* kept) {
  std::size_t kept_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Codeword word = words[i];
    std::size_t b = 0;
    while (b < total && !excludes(blocks[b], word, min_hamming)) ++b;
    if (b == total) {
      kept[kept_count++] = static_cast<std::uint32_t>(i);
    } else if (b > 0 && b < full) {
      std::swap(blocks[b], blocks[b / 2]);
    }
  }
  return kept_count;
}

}  // namespace tagmint::codec::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec {

HWY_EXPORT(keep_distant_vector);

std::size_t keep_distant(std::span<const Codeword> words, TurnBlocks& blocks, int min_hamming,
                         std::uint32_t* kept) {
  return HWY_DYNAMIC_DISPATCH(keep_distant_vector)(words.data(), words.size(), blocks.data(),
                                                   blocks.full(), blocks.size(), min_hamming, kept);
}

std::size_t keep_distant_scalar(std::span<const Codeword> words, TurnBlocks& blocks,
                                int min_hamming, std::uint32_t* kept) {
  const auto excludes = [min_hamming](const TurnBlocks::Block& block, Codeword word) {
    for (const Codeword code : block.words) {
      if (hamming_distance(code, word) < min_hamming) return true;
    }
    return false;
  };
  std::size_t kept_count = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::size_t b = 0;
    while (b < blocks.size() && !excludes(blocks.data()[b], words[i])) ++b;
    if (b == blocks.size()) {
      kept[kept_count++] = static_cast<std::uint32_t>(i);
    } else if (b > 0 && b < blocks.full()) {
      std::swap(blocks.data()[b], blocks.data()[b / 2]);
    }
  }
  return kept_count;
}

}  // namespace tagmint::codec
#endif  // HWY_ONCE
