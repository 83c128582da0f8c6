#include "kernels/halve_kernels.h"

// Highway compiles this file once for each set of instructions.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/halve_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

// A vector of one byte holds no pair.
using scalar::halve_rows;

#else

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::ScalableTag<std::uint8_t>;
using Pairs = hn::RepartitionToWide<Bytes>;
using SignedPairs = hn::RebindToSigned<Pairs>;
using Halved = hn::Rebind<std::uint8_t, Pairs>;

/// Sum of the two pixels of each pair.
HWY_ATTR hn::Vec<Pairs> pair_sums(const std::uint8_t* pixels) {
  const Pairs d;
  const auto both = hn::BitCast(d, hn::LoadU(Bytes(), pixels));
  return hn::Add(hn::And(both, hn::Set(d, 0xff)), hn::ShiftRight<8>(both));
}

HWY_ATTR void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int pixels,
                         std::uint8_t* out) {
  const Pairs d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= pixels; i += lanes) {
    const auto sum = hn::Add(pair_sums(upper + 2 * i), pair_sums(lower + 2 * i));
    const auto mean = hn::ShiftRight<2>(hn::Add(sum, hn::Set(d, 2)));
    hn::StoreU(hn::DemoteTo(Halved(), hn::BitCast(SignedPairs(), mean)), Halved(), out + i);
  }
  scalar::halve_rows(upper + 2 * i, lower + 2 * i, pixels - i, out + i);
}

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {

void scalar::halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int pixels,
                        std::uint8_t* out) {
  for (int i = 0; i < pixels; ++i) {
    const int sum = upper[2 * i] + upper[2 * i + 1] + lower[2 * i] + lower[2 * i + 1];
    out[i] = static_cast<std::uint8_t>((sum + 2) / 4);
  }
}

HWY_EXPORT(halve_rows);

void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int pixels,
                std::uint8_t* out) {
  HWY_DYNAMIC_DISPATCH(halve_rows)(upper, lower, pixels, out);
}

}  // namespace tagmint::detect
#endif
