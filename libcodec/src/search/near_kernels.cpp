#include <algorithm>
#include <bit>

#include "search/near_list.h"

#define HWY_WANT_AVX3_DL  // the AVX-512 that counts bits
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/near_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec::near_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<std::uint32_t, NearList::kPadding>;
using SignedTag = hn::RebindToSigned<Tag>;

/// Whether least <= value < too_large in one signed comparison: both are moved so that `least`
/// becomes the smallest number there is.
class RadiusRange {
 public:
  RadiusRange(NearEntry least, NearEntry too_large)
      : down_(hn::Set(Tag(), least + kSmallest)),
        too_large_(hn::Set(SignedTag(), static_cast<std::int32_t>(too_large - least - kSmallest))) {
  }
  hn::Mask<Tag> has(hn::Vec<Tag> entry) const {
    const auto moved = hn::BitCast(SignedTag(), hn::Sub(entry, down_));
    return hn::RebindMask(Tag(), hn::Lt(moved, too_large_));
  }

 private:
  static constexpr NearEntry kSmallest = NearEntry{1} << 31;
  hn::Vec<Tag> down_;
  hn::Vec<SignedTag> too_large_;
};

/// Stores the lanes of `mask` side by side; writes a whole vector. Returns their number.
HWY_INLINE std::size_t store_chosen(hn::Vec<Tag> values, hn::Mask<Tag> mask, NearEntry* out) {
  hn::StoreU(hn::Compress(values, mask), Tag(), out);
  return hn::CountTrue(Tag(), mask);
}

std::size_t narrow_vector(const NearEntry* HWY_RESTRICT entries, std::size_t count,
                          const Narrowing& narrowing, NearEntry* HWY_RESTRICT out) {
  const Tag d;
  const auto bits = hn::Set(d, narrowing.bits);
  const auto mask = hn::Set(d, narrowing.mask);
  const RadiusRange range(narrowing.least, narrowing.too_large);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto entry = hn::LoadU(d, entries + i);
    const auto differing = hn::PopulationCount(hn::And(hn::Xor(entry, bits), mask));
    const auto narrowed = hn::Sub(entry, hn::ShiftLeft<kNearBits>(differing));
    kept += store_chosen(narrowed, range.has(narrowed), out + kept);
  }
  return kept;
}

std::size_t reach_vector(const SplitTurns& turns, const Subtree& subtree,
                         NearEntry* HWY_RESTRICT out) {
  const Tag d;
  const SignedTag signed_d;
  const auto upper = hn::Set(d, static_cast<std::uint32_t>(subtree.prefix >> 32));
  const auto lower = hn::Set(d, static_cast<std::uint32_t>(subtree.prefix));
  const auto mask = hn::Set(d, subtree.mask);
  const auto radius = hn::Set(signed_d, subtree.radius);
  const std::size_t lanes = hn::Lanes(d);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < turns.size(); i += lanes) {
    const auto turn = hn::LoadU(d, turns.lower() + i);
    const auto above = hn::PopulationCount(hn::Xor(hn::LoadU(d, turns.upper() + i), upper));
    const auto below = hn::PopulationCount(hn::AndNot(mask, hn::Xor(turn, lower)));
    const auto left = hn::Sub(radius, hn::BitCast(signed_d, hn::Add(above, below)));
    const auto entry = hn::Or(hn::And(turn, mask), hn::ShiftLeft<kNearBits>(hn::BitCast(d, left)));
    auto reaches = hn::RebindMask(d, hn::Gt(left, hn::Set(signed_d, -1)));
    if (i + lanes > turns.size()) reaches = hn::And(reaches, hn::FirstN(d, turns.size() - i));
    kept += store_chosen(entry, reaches, out + kept);
  }
  return kept;
}

/// Whether an entry excludes `word`.
HWY_INLINE bool excludes(const NearEntry* entries, std::size_t count, std::uint32_t word,
                         hn::Vec<Tag> mask) {
  const Tag d;
  const SignedTag signed_d;
  const auto probe = hn::Set(d, word);
  const auto is_far = [&](const NearEntry* at) HWY_ATTR {
    const auto entry = hn::LoadU(d, at);
    const auto differing =
        hn::BitCast(signed_d, hn::PopulationCount(hn::And(hn::Xor(entry, probe), mask)));
    return hn::Gt(differing, hn::ShiftRight<kNearBits>(hn::BitCast(signed_d, entry)));
  };
  // Four vectors for each branch.
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t i = 0; i < count; i += 4 * lanes) {
    const auto first = hn::And(is_far(entries + i), is_far(entries + i + lanes));
    const auto second = hn::And(is_far(entries + i + 2 * lanes), is_far(entries + i + 3 * lanes));
    if (!hn::AllTrue(signed_d, hn::And(first, second))) return true;
  }
  return false;
}

std::size_t keep_open_vector(const NearEntry* entries, std::size_t count,
                             std::span<std::uint32_t> words, NearEntry mask_bits) {
  const auto mask = hn::Set(Tag(), mask_bits);
  std::size_t kept = 0;
  for (const std::uint32_t word : words) {
    words[kept] = word;
    kept += !excludes(entries, count, word, mask);
  }
  return kept;
}

}  // namespace tagmint::codec::near_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec::near_kernels {

HWY_EXPORT(narrow_vector);
HWY_EXPORT(reach_vector);
HWY_EXPORT(keep_open_vector);

std::size_t narrow(const NearEntry* entries, std::size_t count, const Narrowing& narrowing,
                   NearEntry* out) {
  return HWY_DYNAMIC_DISPATCH(narrow_vector)(entries, count, narrowing, out);
}

std::size_t narrow_scalar(const NearEntry* entries, std::size_t count, const Narrowing& narrowing,
                          NearEntry* out) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int differing = std::popcount((entries[i] ^ narrowing.bits) & narrowing.mask);
    const int radius = radius_of(entries[i]) - differing;
    if (radius < radius_of(narrowing.least) || radius >= radius_of(narrowing.too_large)) continue;
    out[kept++] = near_entry(entries[i], radius);
  }
  return kept;
}

std::size_t reach(const SplitTurns& turns, const Subtree& subtree, NearEntry* out) {
  return HWY_DYNAMIC_DISPATCH(reach_vector)(turns, subtree, out);
}

std::size_t reach_scalar(const SplitTurns& turns, const Subtree& subtree, NearEntry* out) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Codeword turn = Codeword{turns.upper()[i]} << 32 | turns.lower()[i];
    const int left =
        subtree.radius - std::popcount((turn ^ subtree.prefix) & ~Codeword{subtree.mask});
    if (left >= 0) out[kept++] = near_entry(turns.lower()[i] & subtree.mask, left);
  }
  return kept;
}

std::size_t keep_open(const NearEntry* entries, std::size_t count, std::span<std::uint32_t> words,
                      NearEntry mask) {
  return HWY_DYNAMIC_DISPATCH(keep_open_vector)(entries, count, words, mask);
}

std::size_t keep_open_scalar(const NearEntry* entries, std::size_t count,
                             std::span<std::uint32_t> words, NearEntry mask) {
  const auto excluded = [&](std::uint32_t word) {
    return std::any_of(entries, entries + count, [&](NearEntry entry) {
      return std::popcount((entry ^ word) & mask) <= radius_of(entry);
    });
  };
  return std::remove_if(words.begin(), words.end(), excluded) - words.begin();
}

}  // namespace tagmint::codec::near_kernels
#endif  // HWY_ONCE
