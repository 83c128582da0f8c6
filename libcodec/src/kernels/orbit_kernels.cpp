#include "kernels/orbit_kernels.h"

#include <bit>

// Highway compiles this file once for each set of instructions.
#define HWY_WANT_AVX3_DL
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/orbit_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// At most 64 bytes, so that 64 addresses are whole vectors. Addresses are small enough to be
/// compared as signed numbers, which is cheaper.
using Addresses = hn::CappedTag<std::int32_t, 16>;

HWY_ATTR std::uint64_t smallest_of_orbit_of(const LowAddresses& low, const HighAddress& high) {
  const Addresses d;
  const std::size_t lanes = hn::Lanes(d);
  const auto own_start = hn::Set(d, static_cast<std::int32_t>(high.address));
  const auto start1 = hn::Set(d, static_cast<std::int32_t>(high.turned[0]));
  const auto start2 = hn::Set(d, static_cast<std::int32_t>(high.turned[1]));
  const auto start3 = hn::Set(d, static_cast<std::int32_t>(high.turned[2]));
  const auto turned = [&](int turn, std::size_t i) HWY_ATTR {
    return hn::Load(d, reinterpret_cast<const std::int32_t*>(&low.turned[turn][i]));
  };
  std::uint64_t smallest = 0;
  for (std::size_t i = 0; i < 64; i += lanes) {
    const auto own = hn::Xor(own_start, hn::Iota(d, static_cast<std::int32_t>(i)));
    const auto least =
        hn::Min(hn::Xor(start1, turned(0, i)),
                hn::Min(hn::Xor(start2, turned(1, i)), hn::Xor(start3, turned(2, i))));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Lt(own, least), bits);
    smallest |= static_cast<std::uint64_t>(bits[0] | bits[1] << 8) << i;
  }
  return smallest;
}

/// Alike for all sets of instructions but for how they count bits.
HWY_ATTR std::uint64_t with_changes_of(std::uint64_t chosen, const LowAddresses& low,
                                       const HighAddress& high, int least) {
  std::uint64_t enough = 0;
  for (std::uint64_t rest = chosen; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    int changes = 0;
    for (std::size_t word = 0; word < high.changes.size(); ++word) {
      changes += std::popcount(high.changes[word] ^ low.changes[i][word]);
    }
    enough |= std::uint64_t{changes >= least} << i;
  }
  return enough;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::codec
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec {
namespace {

HWY_EXPORT(smallest_of_orbit_of);
HWY_EXPORT(with_changes_of);

}  // namespace

std::uint64_t smallest_of_orbit(const LowAddresses& low, const HighAddress& high) {
  return HWY_DYNAMIC_DISPATCH(smallest_of_orbit_of)(low, high);
}

std::uint64_t with_changes(std::uint64_t chosen, const LowAddresses& low, const HighAddress& high,
                           int least) {
  return HWY_DYNAMIC_DISPATCH(with_changes_of)(chosen, low, high, least);
}

namespace scalar {

std::uint64_t smallest_of_orbit(const LowAddresses& low, const HighAddress& high) {
  std::uint64_t smallest = 0;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const std::uint32_t own = high.address ^ i;
    bool is_smallest = true;
    for (int turn = 0; turn < 3; ++turn) {
      is_smallest = is_smallest && own < (high.turned[turn] ^ low.turned[turn][i]);
    }
    smallest |= std::uint64_t{is_smallest} << i;
  }
  return smallest;
}

std::uint64_t with_changes(std::uint64_t chosen, const LowAddresses& low, const HighAddress& high,
                           int least) {
  std::uint64_t enough = 0;
  for (std::uint64_t i = 0; i < 64; ++i) {
    if (((chosen >> i) & 1) == 0) continue;
    int changes = 0;
    for (std::size_t word = 0; word < high.changes.size(); ++word) {
      changes += std::popcount(high.changes[word] ^ low.changes[i][word]);
    }
    if (changes >= least) enough |= std::uint64_t{1} << i;
  }
  return enough;
}

}  // namespace scalar
}  // namespace tagmint::codec
#endif  // HWY_ONCE
