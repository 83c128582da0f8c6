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

std::size_t narrow_vector(const NearEntry* HWY_RESTRICT entries, std::size_t count,
                          const Narrowing& narrowing, NearEntry* HWY_RESTRICT out) {
  const Tag d;
  const SignedTag signed_d;
  const auto bits = hn::Set(d, narrowing.bits);
  const auto mask = hn::Set(d, narrowing.mask);
  const auto too_small = hn::Set(signed_d, static_cast<std::int32_t>(narrowing.least) - 1);
  const auto too_large = hn::BitCast(signed_d, hn::Set(d, narrowing.too_large));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto entry = hn::LoadU(d, entries + i);
    const auto differing = hn::PopulationCount(hn::And(hn::Xor(entry, bits), mask));
    const auto narrowed =
        hn::BitCast(signed_d, hn::Sub(entry, hn::ShiftLeft<kNearBits>(differing)));
    const auto fits = hn::And(hn::Gt(narrowed, too_small), hn::Lt(narrowed, too_large));
    kept += hn::CompressStore(hn::BitCast(d, narrowed), hn::RebindMask(d, fits), d, out + kept);
  }
  return kept;
}

bool excludes_vector(const NearEntry* entries, std::size_t count, std::uint32_t word,
                     NearEntry mask_bits) {
  const Tag d;
  const SignedTag signed_d;
  const auto probe = hn::Set(d, word);
  const auto mask = hn::Set(d, mask_bits);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto entry = hn::LoadU(d, entries + i);
    const auto differing =
        hn::BitCast(signed_d, hn::PopulationCount(hn::And(hn::Xor(entry, probe), mask)));
    const auto radius = hn::ShiftRight<kNearBits>(hn::BitCast(signed_d, entry));
    if (!hn::AllTrue(signed_d, hn::Gt(differing, radius))) return true;
  }
  return false;
}

}  // namespace tagmint::codec::near_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec::near_kernels {

HWY_EXPORT(narrow_vector);
HWY_EXPORT(excludes_vector);

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

bool excludes(const NearEntry* entries, std::size_t count, std::uint32_t word, NearEntry mask) {
  return HWY_DYNAMIC_DISPATCH(excludes_vector)(entries, count, word, mask);
}

bool excludes_scalar(const NearEntry* entries, std::size_t count, std::uint32_t word,
                     NearEntry mask) {
  for (std::size_t i = 0; i < count; ++i) {
    if (std::popcount((entries[i] ^ word) & mask) <= radius_of(entries[i])) return true;
  }
  return false;
}

}  // namespace tagmint::codec::near_kernels
#endif  // HWY_ONCE
