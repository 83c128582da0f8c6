#include "numerics/normal_profile.h"

#include <algorithm>
#include <cmath>

#include "numerics/bilinear.h"

namespace tagmint::detect {
namespace {

/// Changes below this share of the steepest one belong to noise, not to the edge.
constexpr float kEdgeShare = 0.25f;
/// Gray levels; flatter places have no edge.
constexpr float kMinChange = 2.0f;
constexpr double kStep = 0.5;

/// Area under a piecewise linear curve and its moment about the place of the steepest change,
/// steps.
struct Heap {
  float area = 0;
  float moment = 0;

  /// One side of the heap from its top, towards growing indices (direction 1) or falling ones (-1).
  void add_side(const NormalProfile& profile, int direction, float floor) {
    const int end = direction > 0 ? profile.changes() : -1;
    float here = profile.change(profile.steepest) - floor;
    float place = 0;  // steps from the steepest change
    float side_area = 0, side_moment = 0;
    for (int i = profile.steepest + direction; i != end; i += direction, place += 1) {
      const float next = profile.change(i) - floor;
      if (next <= 0) {  // a triangle down to the floor
        const float run = here / (here - next);
        side_area += here * run / 2;
        side_moment += here * run / 2 * (place + run / 3);
        break;
      }
      side_area += (here + next) / 2;
      side_moment += (here + next) / 2 * place + (here + 2 * next) / 6;
      here = next;
    }
    area += side_area;
    moment += static_cast<float>(direction) * side_moment;
  }
};

/// Coordinates in whole 2^-15 px, which reach to 131,071 px in 32 bits; the place within a pixel
/// counts in 2^-8, a sixth of a gray level at the steepest edge.
constexpr int kPlaceBits = 15;
constexpr int kShareBits = 8;
constexpr std::uint32_t kShareMask = (1u << kShareBits) - 1;
constexpr double kPlaceUnits = 1 << kPlaceBits;

/// Fills profile.gray with `count` values from `start` on, which with the last one lies well inside
/// the image.
void sample_line(ImageView image, Point start, Point step, int count, float sign,
                 NormalProfile& profile) {
  // Pixel (i, j) has its value at its centre (i + 0.5, j + 0.5). Beyond the last column or row the
  // next pixel has no weight; the one before stands in for it.
  auto u = static_cast<std::uint32_t>(std::max(0.0, (start.x - 0.5) * kPlaceUnits));
  auto v = static_cast<std::uint32_t>(std::max(0.0, (start.y - 0.5) * kPlaceUnits));
  const auto du = static_cast<std::uint32_t>(static_cast<std::int32_t>(step.x * kPlaceUnits));
  const auto dv = static_cast<std::uint32_t>(static_cast<std::int32_t>(step.y * kPlaceUnits));
  const std::uint32_t last_x =
      static_cast<std::uint32_t>(image.width - 2) << kPlaceBits | ((1u << kPlaceBits) - 1);
  const std::uint32_t last_y =
      static_cast<std::uint32_t>(image.height - 2) << kPlaceBits | ((1u << kPlaceBits) - 1);
  const float scale = sign / (1 << 2 * kShareBits);
  for (int i = 0; i < count; ++i, u += du, v += dv) {
    const std::uint32_t x = std::min(u, last_x), y = std::min(v, last_y);
    const auto fx = static_cast<int>(x >> (kPlaceBits - kShareBits) & kShareMask);
    const auto fy = static_cast<int>(y >> (kPlaceBits - kShareBits) & kShareMask);
    const std::uint8_t* top = image.data +
                              static_cast<std::ptrdiff_t>(y >> kPlaceBits) * image.stride +
                              (x >> kPlaceBits);
    const std::uint8_t* bottom = top + image.stride;
    const int upper = (top[0] << kShareBits) + fx * (top[1] - top[0]);
    const int lower = (bottom[0] << kShareBits) + fx * (bottom[1] - bottom[0]);
    const int value = (upper << kShareBits) + fy * (lower - upper);
    profile.gray[static_cast<std::size_t>(i)] = scale * static_cast<float>(value);
  }
}

}  // namespace

std::optional<NormalProfile> read_profile(ImageView image, Point foot, Point outward, double search,
                                          bool rising) {
  NormalProfile p;
  const double step_px = std::max(kStep, search / NormalProfile::kMaxReach);
  p.step = static_cast<float>(step_px);
  p.reach = std::min(NormalProfile::kMaxReach, static_cast<int>(std::ceil(search / step_px)));
  const int values = p.changes() + 2 * NormalProfile::kHalfChange;
  const Point step = step_px * outward;
  const Point start = foot - static_cast<double>(p.reach + NormalProfile::kHalfChange) * step;
  if (!well_inside(image, start) || !well_inside(image, start + (values - 1.0) * step)) {
    return std::nullopt;
  }
  sample_line(image, start, step, values, rising ? 1.0f : -1.0f, p);
  float steepest = 0, darkest = p.gray[0], brightest = p.gray[0];
  for (int i = 0; i < p.changes(); ++i) {
    if (p.change(i) > steepest) {
      steepest = p.change(i);
      p.steepest = i;
    }
  }
  if (steepest < kMinChange) return std::nullopt;
  for (int i = 1; i < values; ++i) {
    darkest = std::min(darkest, p.gray[static_cast<std::size_t>(i)]);
    brightest = std::max(brightest, p.gray[static_cast<std::size_t>(i)]);
  }
  p.darkest = darkest;
  p.brightest = brightest;
  return p;
}

float mean_place_of_changes(const NormalProfile& profile) {
  const float floor = kEdgeShare * profile.change(profile.steepest);
  Heap heap;
  heap.add_side(profile, 1, floor);
  heap.add_side(profile, -1, floor);
  const auto top = static_cast<float>(profile.steepest);
  return profile.place_of(heap.area > 0 ? top + heap.moment / heap.area : top);
}

std::optional<float> crossing_place(const NormalProfile& profile, float level) {
  const int middle = profile.steepest + NormalProfile::kHalfChange;  // index into gray
  const int last = profile.changes() + 2 * NormalProfile::kHalfChange - 1;
  for (int away = 0; away <= last; ++away) {
    for (const int i : {middle - 1 - away, middle + away}) {
      if (i < 0 || i >= last) continue;
      const float before = profile.gray[static_cast<std::size_t>(i)];
      const float after = profile.gray[static_cast<std::size_t>(i) + 1];
      if (before > level || after <= level) continue;
      const float part = (level - before) / (after - before);
      return profile.place_of(static_cast<float>(i - NormalProfile::kHalfChange) + part);
    }
  }
  return std::nullopt;
}

}  // namespace tagmint::detect
