#include <algorithm>
#include <array>
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

Parts part_vector(const NearEntry* entries, std::size_t count, int radius,
                  NearEntry* HWY_RESTRICT equal, NearEntry* larger) {
  const Tag d;
  const SignedTag signed_d;
  const auto radii = hn::Set(signed_d, radius);
  Parts parts{0, 0};
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto entry = hn::LoadU(d, entries + i);
    const auto own = hn::ShiftRight<kNearBits>(hn::BitCast(signed_d, entry));
    parts.equal += store_chosen(entry, hn::RebindMask(d, hn::Eq(own, radii)), equal + parts.equal);
    parts.larger +=
        store_chosen(entry, hn::RebindMask(d, hn::Gt(own, radii)), larger + parts.larger);
  }
  return parts;
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

/// Four vectors of entries, taken apart.
class FourVectors {
 public:
  explicit FourVectors(const NearEntry* entries)
      : bits0_(hn::LoadU(Tag(), entries)),
        bits1_(hn::LoadU(Tag(), entries + hn::Lanes(Tag()))),
        bits2_(hn::LoadU(Tag(), entries + 2 * hn::Lanes(Tag()))),
        bits3_(hn::LoadU(Tag(), entries + 3 * hn::Lanes(Tag()))),
        radius0_(radii(bits0_)),
        radius1_(radii(bits1_)),
        radius2_(radii(bits2_)),
        radius3_(radii(bits3_)) {}

  /// The lanes of which no entry excludes `word`.
  HWY_INLINE hn::Mask<SignedTag> far_from(hn::Vec<Tag> word, hn::Vec<Tag> mask) const {
    const auto is_far = [&](hn::Vec<Tag> bits, hn::Vec<SignedTag> radius) HWY_ATTR {
      const auto differing = hn::PopulationCount(hn::And(hn::Xor(bits, word), mask));
      return hn::Gt(hn::BitCast(SignedTag(), differing), radius);
    };
    return hn::And(hn::And(is_far(bits0_, radius0_), is_far(bits1_, radius1_)),
                   hn::And(is_far(bits2_, radius2_), is_far(bits3_, radius3_)));
  }

 private:
  static HWY_INLINE hn::Vec<SignedTag> radii(hn::Vec<Tag> entries) {
    return hn::ShiftRight<kNearBits>(hn::BitCast(SignedTag(), entries));
  }
  hn::Vec<Tag> bits0_, bits1_, bits2_, bits3_;
  hn::Vec<SignedTag> radius0_, radius1_, radius2_, radius3_;
};

constexpr std::size_t kBlock = 8 * hn::MaxLanes(Tag());

/// keep_open() for kBlock entries. They stay in registers while all words pass by; whether a word
/// stays is no branch, because it could not be foretold.
HWY_INLINE std::size_t keep_open_of_block(const NearEntry* block, std::span<std::uint32_t> words,
                                          hn::Vec<Tag> mask) {
  const FourVectors first(block);
  const FourVectors second(block + kBlock / 2);
  std::size_t kept = 0;
  for (const std::uint32_t word : words) {
    const auto probe = hn::Set(Tag(), word);
    words[kept] = word;
    kept += hn::AllTrue(SignedTag(),
                        hn::And(first.far_from(probe, mask), second.far_from(probe, mask)));
  }
  return kept;
}

std::size_t keep_open_vector(const NearEntry* entries, std::size_t count,
                             std::span<std::uint32_t> words, NearEntry mask_bits) {
  const auto mask = hn::Set(Tag(), mask_bits);
  std::size_t i = 0;
  for (; i + kBlock <= count && !words.empty(); i += kBlock) {
    words = words.first(keep_open_of_block(entries + i, words, mask));
  }
  if (i >= count || words.empty()) return words.size();
  std::array<NearEntry, kBlock> rest;
  std::fill(std::copy(entries + i, entries + count, rest.begin()), rest.end(), kNothing);
  return keep_open_of_block(rest.data(), words, mask);
}

}  // namespace tagmint::codec::near_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec::near_kernels {

HWY_EXPORT(narrow_vector);
HWY_EXPORT(part_vector);
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

Parts part(const NearEntry* entries, std::size_t count, int radius, NearEntry* equal,
           NearEntry* larger) {
  return HWY_DYNAMIC_DISPATCH(part_vector)(entries, count, radius, equal, larger);
}

Parts part_scalar(const NearEntry* entries, std::size_t count, int radius, NearEntry* equal,
                  NearEntry* larger) {
  Parts parts{0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    if (radius_of(entries[i]) == radius) equal[parts.equal++] = entries[i];
    if (radius_of(entries[i]) > radius) larger[parts.larger++] = entries[i];
  }
  return parts;
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
