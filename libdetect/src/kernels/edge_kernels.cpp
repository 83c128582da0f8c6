#include "kernels/edge_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

// Highway compiles this file once for each set of instructions. All of them give the same floats,
// since products and sums are not contracted (see CMakeLists.txt).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/edge_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Scans are padded to 16.
using Whole = hn::CappedTag<std::int32_t, 16>;
using Floats = hn::Repartition<float, Whole>;
using Bytes = hn::Rebind<std::uint8_t, Whole>;
using WholeVector = hn::Vec<Whole>;

int lanes() { return static_cast<int>(hn::Lanes(Whole())); }

/// 1 in the lanes of scan lines i, i + 1, ... that are below count.
HWY_ATTR hn::Mask<Whole> present(int i, int count) {
  return hn::FirstN(Whole(), static_cast<std::size_t>(std::max(0, count - i)));
}

HWY_ATTR WholeVector pixels(const EdgeScans& scans, int pixel, int i) {
  return hn::PromoteTo(Whole(), hn::LoadU(Bytes(), scans.gray[pixel].data() + i));
}

HWY_ATTR int twice_middle_level(const EdgeScans& scans) {
  const Whole d;
  auto sum = hn::Zero(d);
  for (int i = 0; i < scans.count; i += lanes()) {
    auto low = pixels(scans, 0, i);
    auto high = low;
    for (int pixel = 1; pixel < kScanPixels; ++pixel) {
      const auto value = pixels(scans, pixel, i);
      low = hn::Min(low, value);
      high = hn::Max(high, value);
    }
    sum = hn::Add(sum, hn::IfThenElseZero(present(i, scans.count), hn::Add(low, high)));
  }
  return hn::GetLane(hn::SumOfLanes(d, sum)) / scans.count;
}

HWY_ATTR void find_edge_points(const EdgeScans& scans, int twice_level, EdgePoints& points) {
  const Whole d;
  const Floats df;
  const auto level = hn::Set(d, twice_level);
  const auto parts = hn::Set(d, kParts);
  const auto half = hn::Set(d, kParts / 2);
  for (int i = 0; i < scans.count; i += lanes()) {
    const auto expected = hn::Load(d, scans.expected.data() + i);
    // Which crossing is nearest is judged by its middle between two pixels.
    auto nearest = hn::Set(d, 1 << 20);
    auto at = hn::Zero(d);
    auto inner = hn::Zero(d);
    auto outer = hn::Set(d, 2);
    auto last = pixels(scans, 0, i);
    last = hn::Add(last, last);
    auto place = hn::Zero(d);
    for (int pixel = 1; pixel < kScanPixels; ++pixel) {
      auto value = pixels(scans, pixel, i);
      value = hn::Add(value, value);
      const auto distance = hn::Abs(hn::Sub(hn::Add(place, half), expected));
      const auto passes = hn::AndNot(hn::Lt(value, level), hn::Lt(last, level));
      const auto take = hn::And(passes, hn::Lt(distance, nearest));
      nearest = hn::IfThenElse(take, distance, nearest);
      at = hn::IfThenElse(take, place, at);
      inner = hn::IfThenElse(take, last, inner);
      outer = hn::IfThenElse(take, value, outer);
      last = value;
      place = hn::Add(place, parts);
    }
    const auto rise = hn::ConvertTo(df, hn::Sub(outer, inner));
    const auto part = hn::Div(hn::ConvertTo(df, hn::ShiftLeft<8>(hn::Sub(level, inner))), rise);
    const auto found = hn::And(hn::Lt(nearest, hn::Set(d, 1 << 20)), present(i, scans.count));
    const auto off = hn::Sub(hn::Add(at, hn::ConvertTo(d, part)), expected);
    hn::Store(hn::IfThenElseZero(found, off), d, points.off.data() + i);
    hn::Store(hn::IfThenElseZero(found, hn::Set(d, 1)), d, points.counts.data() + i);
  }
}

HWY_ATTR std::int32_t total(WholeVector v) { return hn::GetLane(hn::SumOfLanes(Whole(), v)); }

HWY_ATTR EdgeSums sum_edge_points(const EdgeScans& scans, const EdgePoints& points) {
  const Whole d;
  const auto zero = hn::Zero(d);
  auto n = zero, t = zero, o = zero, tt = zero, to = zero, oo = zero;
  for (int i = 0; i < scans.count; i += lanes()) {
    const auto counts = hn::Load(d, points.counts.data() + i);
    const auto along = hn::Mul(hn::Load(d, scans.along.data() + i), counts);
    const auto off = hn::Mul(hn::Load(d, points.off.data() + i), counts);
    n = hn::Add(n, counts);
    t = hn::Add(t, along);
    o = hn::Add(o, off);
    tt = hn::Add(tt, hn::Mul(along, along));
    to = hn::Add(to, hn::Mul(along, off));
    oo = hn::Add(oo, hn::Mul(off, off));
  }
  return {total(n), total(t), total(o), total(tt), total(to), total(oo)};
}

HWY_ATTR void drop_far_points(const EdgeScans& scans, float at_zero, float slope, float limit,
                              EdgePoints& points) {
  const Whole d;
  const Floats df;
  const auto base = hn::Set(df, at_zero), rise = hn::Set(df, slope), most = hn::Set(df, limit);
  for (int i = 0; i < scans.count; i += lanes()) {
    const auto along = hn::ConvertTo(df, hn::Load(d, scans.along.data() + i));
    const auto off = hn::ConvertTo(df, hn::Load(d, points.off.data() + i));
    const auto far = hn::Gt(hn::Abs(hn::Sub(off, hn::Add(base, hn::Mul(rise, along)))), most);
    const auto counts = hn::Load(d, points.counts.data() + i);
    hn::Store(hn::IfThenZeroElse(hn::RebindMask(d, far), counts), d, points.counts.data() + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {

int scalar::twice_middle_level(const EdgeScans& scans) {
  int sum = 0;
  for (int i = 0; i < scans.count; ++i) {
    int low = 255;
    int high = 0;
    for (const auto& row : scans.gray) {
      low = std::min<int>(low, row[static_cast<std::size_t>(i)]);
      high = std::max<int>(high, row[static_cast<std::size_t>(i)]);
    }
    sum += low + high;
  }
  return sum / scans.count;
}

void scalar::find_edge_points(const EdgeScans& scans, int twice_level, EdgePoints& points) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(scans.count); ++i) {
    int nearest = 1 << 20;
    points.off[i] = 0;
    points.counts[i] = 0;
    for (int pixel = 0; pixel + 1 < kScanPixels; ++pixel) {
      const int inner = 2 * scans.gray[static_cast<std::size_t>(pixel)][i];
      const int outer = 2 * scans.gray[static_cast<std::size_t>(pixel) + 1][i];
      const int distance = std::abs(pixel * kParts + kParts / 2 - scans.expected[i]);
      if (inner >= twice_level || outer < twice_level || distance >= nearest) continue;
      nearest = distance;
      const float part =
          static_cast<float>((twice_level - inner) * kParts) / static_cast<float>(outer - inner);
      points.off[i] = pixel * kParts + static_cast<int>(part) - scans.expected[i];
      points.counts[i] = 1;
    }
  }
}

EdgeSums scalar::sum_edge_points(const EdgeScans& scans, const EdgePoints& points) {
  EdgeSums sums;
  for (std::size_t i = 0; i < static_cast<std::size_t>(scans.count); ++i) {
    if (points.counts[i] == 0) continue;
    const std::int32_t along = scans.along[i];
    const std::int32_t off = points.off[i];
    ++sums.n;
    sums.along += along;
    sums.off += off;
    sums.along_along += along * along;
    sums.along_off += along * off;
    sums.off_off += off * off;
  }
  return sums;
}

void scalar::drop_far_points(const EdgeScans& scans, float at_zero, float slope, float limit,
                             EdgePoints& points) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(scans.count); ++i) {
    const float line = at_zero + slope * static_cast<float>(scans.along[i]);
    if (std::abs(static_cast<float>(points.off[i]) - line) > limit) points.counts[i] = 0;
  }
}

HWY_EXPORT(twice_middle_level);
HWY_EXPORT(find_edge_points);
HWY_EXPORT(sum_edge_points);
HWY_EXPORT(drop_far_points);

int twice_middle_level(const EdgeScans& scans) {
  return HWY_DYNAMIC_DISPATCH(twice_middle_level)(scans);
}
void find_edge_points(const EdgeScans& scans, int twice_level, EdgePoints& points) {
  HWY_DYNAMIC_DISPATCH(find_edge_points)(scans, twice_level, points);
}
EdgeSums sum_edge_points(const EdgeScans& scans, const EdgePoints& points) {
  return HWY_DYNAMIC_DISPATCH(sum_edge_points)(scans, points);
}
void drop_far_points(const EdgeScans& scans, float at_zero, float slope, float limit,
                     EdgePoints& points) {
  HWY_DYNAMIC_DISPATCH(drop_far_points)(scans, at_zero, slope, limit, points);
}

}  // namespace tagmint::detect
#endif
