#include "kernels/count_within.h"

#include <algorithm>

// Highway compiles this file once for each set of instructions.
#define HWY_WANT_AVX3_DL
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/count_within.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

HWY_ATTR std::size_t count_within_of(std::span<const Codeword> words, Codeword probe, int radius) {
  const hn::ScalableTag<std::uint64_t> d;
  const hn::RebindToSigned<decltype(d)> ds;
  const std::size_t lanes = hn::Lanes(d);
  const auto probes = hn::Set(d, probe);
  const auto too_far = hn::Set(ds, std::int64_t{radius} + 1);
  auto count = hn::Zero(ds);
  std::size_t i = 0;
  for (; i + lanes <= words.size(); i += lanes) {
    const auto difference = hn::Xor(hn::LoadU(d, words.data() + i), probes);
    const auto distance = hn::BitCast(ds, hn::PopulationCount(difference));
    // A mask as a vector is -1 where it is set.
    count = hn::Sub(count, hn::VecFromMask(ds, hn::Lt(distance, too_far)));
  }
  auto total = static_cast<std::size_t>(hn::GetLane(hn::SumOfLanes(ds, count)));
  for (; i < words.size(); ++i) total += hamming_distance(words[i], probe) <= radius;
  return total;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::codec
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec {
namespace {

HWY_EXPORT(count_within_of);

}  // namespace

std::size_t count_within(std::span<const Codeword> words, Codeword probe, int radius) {
  return HWY_DYNAMIC_DISPATCH(count_within_of)(words, probe, radius);
}

namespace scalar {

std::size_t count_within(std::span<const Codeword> words, Codeword probe, int radius) {
  return static_cast<std::size_t>(std::count_if(words.begin(), words.end(), [&](Codeword word) {
    return hamming_distance(word, probe) <= radius;
  }));
}

}  // namespace scalar
}  // namespace tagmint::codec
#endif  // HWY_ONCE
