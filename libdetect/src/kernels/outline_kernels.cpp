#include "kernels/outline_kernels.h"

#include <array>
#include <cmath>

// Highway compiles this file once for each set of instructions. All of them give the same floats,
// since products and sums are not contracted (see CMakeLists.txt).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/outline_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kOutlinePadding>;
using Indices = hn::Repartition<std::int32_t, Floats>;
using FloatVector = hn::Vec<Floats>;
using IndexVector = hn::Vec<Indices>;

/// Largest value seen by each lane, and where first.
struct LaneMaxima {
  FloatVector value;
  IndexVector index;

  HWY_ATTR void take(FloatVector values, IndexVector indices) {
    const auto larger = hn::Gt(values, value);
    value = hn::IfThenElse(larger, values, value);
    index = hn::IfThenElse(hn::RebindMask(Indices(), larger), indices, index);
  }
  /// The first of the largest values of all lanes.
  HWY_ATTR int best(float* largest) const {
    alignas(64) std::array<float, kOutlinePadding> values;
    alignas(64) std::array<std::int32_t, kOutlinePadding> indices;
    hn::Store(value, Floats(), values.data());
    hn::Store(index, Indices(), indices.data());
    std::size_t best = 0;
    for (std::size_t i = 1; i < hn::Lanes(Floats()); ++i) {
      if (values[i] > values[best] || (values[i] == values[best] && indices[i] < indices[best])) {
        best = i;
      }
    }
    *largest = values[best];
    return indices[best];
  }
};

HWY_ATTR int farthest_point(const OutlineView& outline, float px, float py) {
  const Floats d;
  const Indices di;
  const auto vx = hn::Set(d, px), vy = hn::Set(d, py);
  const auto step = hn::Set(di, static_cast<std::int32_t>(hn::Lanes(d)));
  auto index = hn::Iota(di, 0);
  LaneMaxima most{hn::Set(d, -1.0f), index};
  for (int i = 0; i < outline.size; i += static_cast<int>(hn::Lanes(d))) {
    const auto dx = hn::Sub(hn::LoadU(d, outline.x + i), vx);
    const auto dy = hn::Sub(hn::LoadU(d, outline.y + i), vy);
    most.take(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), index);
    index = hn::Add(index, step);
  }
  float largest = 0;
  return most.best(&largest);
}

HWY_ATTR FarthestBothSides farthest_both_sides(const OutlineView& outline, float ax, float ay,
                                               float ex, float ey) {
  const Floats d;
  const Indices di;
  const auto vx = hn::Set(d, ax), vy = hn::Set(d, ay), wx = hn::Set(d, ex), wy = hn::Set(d, ey);
  const auto step = hn::Set(di, static_cast<std::int32_t>(hn::Lanes(d)));
  auto index = hn::Iota(di, 0);
  const auto least = hn::Set(d, -3e38f);
  LaneMaxima right{least, index}, left{least, index};
  for (int i = 0; i < outline.size; i += static_cast<int>(hn::Lanes(d))) {
    const auto dx = hn::Sub(hn::LoadU(d, outline.x + i), vx);
    const auto dy = hn::Sub(hn::LoadU(d, outline.y + i), vy);
    const auto ahead = hn::Mul(dy, wx), back = hn::Mul(dx, wy);
    right.take(hn::Sub(ahead, back), index);
    left.take(hn::Sub(back, ahead), index);
    index = hn::Add(index, step);
  }
  FarthestBothSides farthest;
  farthest.right = right.best(&farthest.right_distance);
  farthest.left = left.best(&farthest.left_distance);
  return farthest;
}

HWY_ATTR bool all_near_line(const OutlineView& outline, float ax, float ay, float ex, float ey,
                            float most) {
  const Floats d;
  const auto vx = hn::Set(d, ax), vy = hn::Set(d, ay), wx = hn::Set(d, ex), wy = hn::Set(d, ey);
  const auto limit = hn::Set(d, most);
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto far = [&](int i) HWY_ATTR {
    const auto dx = hn::Sub(hn::LoadU(d, outline.x + i), vx);
    const auto dy = hn::Sub(hn::LoadU(d, outline.y + i), vy);
    return hn::Gt(hn::Abs(hn::Sub(hn::Mul(dy, wx), hn::Mul(dx, wy))), limit);
  };
  int i = 0;
  for (; i + lanes <= outline.size; i += lanes) {
    if (!hn::AllFalse(d, far(i))) return false;
  }
  if (i == outline.size) return true;
  const auto rest = hn::FirstN(d, static_cast<std::size_t>(outline.size - i));
  return hn::AllFalse(d, hn::And(far(i), rest));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {

int scalar::farthest_point(const OutlineView& outline, float px, float py) {
  int best = 0;
  float largest = -1;
  for (int i = 0; i < outline.size; ++i) {
    const float dx = outline.x[i] - px;
    const float dy = outline.y[i] - py;
    const float distance = dx * dx + dy * dy;
    if (distance > largest) {
      largest = distance;
      best = i;
    }
  }
  return best;
}

FarthestBothSides scalar::farthest_both_sides(const OutlineView& outline, float ax, float ay,
                                              float ex, float ey) {
  FarthestBothSides farthest{0, 0, -3e38f, -3e38f};
  for (int i = 0; i < outline.size; ++i) {
    const float ahead = (outline.y[i] - ay) * ex;
    const float back = (outline.x[i] - ax) * ey;
    if (ahead - back > farthest.right_distance) {
      farthest.right = i;
      farthest.right_distance = ahead - back;
    }
    if (back - ahead > farthest.left_distance) {
      farthest.left = i;
      farthest.left_distance = back - ahead;
    }
  }
  return farthest;
}

bool scalar::all_near_line(const OutlineView& outline, float ax, float ay, float ex, float ey,
                           float most) {
  for (int i = 0; i < outline.size; ++i) {
    const float off = (outline.y[i] - ay) * ex - (outline.x[i] - ax) * ey;
    if (std::abs(off) > most) return false;
  }
  return true;
}

HWY_EXPORT(all_near_line);
HWY_EXPORT(farthest_point);
HWY_EXPORT(farthest_both_sides);

int farthest_point(const OutlineView& outline, float px, float py) {
  return HWY_DYNAMIC_DISPATCH(farthest_point)(outline, px, py);
}

FarthestBothSides farthest_both_sides(const OutlineView& outline, float ax, float ay, float ex,
                                      float ey) {
  return HWY_DYNAMIC_DISPATCH(farthest_both_sides)(outline, ax, ay, ex, ey);
}

bool all_near_line(const OutlineView& outline, float ax, float ay, float ex, float ey, float most) {
  return HWY_DYNAMIC_DISPATCH(all_near_line)(outline, ax, ay, ex, ey, most);
}

}  // namespace tagmint::detect
#endif
