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

/// The last place that has a pixel to its right, or below it.
std::uint32_t last_place(int pixels) {
  return static_cast<std::uint32_t>(pixels - 2) << kPlaceBits | ((1u << kPlaceBits) - 1);
}

/// Coordinate of a place, counted from the centre of the first pixel, where that has its value.
std::uint32_t place_of(double coordinate) {
  return static_cast<std::uint32_t>(std::max(0.0, (coordinate - 0.5) * kPlaceUnits));
}

std::uint32_t step_of(double step_px) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(step_px * kPlaceUnits));
}

}  // namespace

ProfileReader::ProfileReader(ImageView image, Point outward, double search, bool rising)
    : image_(image), last_x_(last_place(image.width)), last_y_(last_place(image.height)) {
  const double step_px = std::max(kStep, search / NormalProfile::kMaxReach);
  const Point step = step_px * outward;
  step_px_ = static_cast<float>(step_px);
  reach_ = std::min(NormalProfile::kMaxReach, static_cast<int>(std::ceil(search / step_px)));
  values_ = 2 * (reach_ + NormalProfile::kHalfChange) + 1;
  to_end_ = static_cast<double>(reach_ + NormalProfile::kHalfChange) * step;
  to_start_ = -1 * to_end_;
  scale_ = (rising ? 1.0f : -1.0f) / (1 << 2 * kShareBits);
  step_x_ = step_of(step.x);
  step_y_ = step_of(step.y);
}

bool ProfileReader::read(Point foot, NormalProfile& p) const {
  const Point start = foot + to_start_;
  if (!well_inside(image_, start) || !well_inside(image_, foot + to_end_)) return false;
  std::uint32_t u = place_of(start.x), v = place_of(start.y);
  float* const gray = p.gray.data();
  float darkest = 1e9f, brightest = -1e9f;
  for (int i = 0; i < values_; ++i, u += step_x_, v += step_y_) {
    // Beyond the last column or row the next pixel has no weight; the one before stands in for it.
    const std::uint32_t x = std::min(u, last_x_), y = std::min(v, last_y_);
    const auto fx = static_cast<int>(x >> (kPlaceBits - kShareBits) & kShareMask);
    const auto fy = static_cast<int>(y >> (kPlaceBits - kShareBits) & kShareMask);
    const std::uint8_t* const top = image_.data +
                                    static_cast<std::ptrdiff_t>(y >> kPlaceBits) * image_.stride +
                                    (x >> kPlaceBits);
    const std::uint8_t* const bottom = top + image_.stride;
    const int upper = (top[0] << kShareBits) + fx * (top[1] - top[0]);
    const int lower = (bottom[0] << kShareBits) + fx * (bottom[1] - bottom[0]);
    const float value = scale_ * static_cast<float>((upper << kShareBits) + fy * (lower - upper));
    gray[i] = value;
    darkest = std::min(darkest, value);
    brightest = std::max(brightest, value);
  }
  float steepest = 0;
  int at = 0;
  const int changes = 2 * reach_ + 1;
  for (int i = 0; i < changes; ++i) {
    const float change = gray[i + 2 * NormalProfile::kHalfChange] - gray[i];
    at = change > steepest ? i : at;
    steepest = std::max(steepest, change);
  }
  if (steepest < kMinChange) return false;
  p.step = step_px_;
  p.reach = reach_;
  p.steepest = at;
  p.darkest = darkest;
  p.brightest = brightest;
  return true;
}

std::optional<NormalProfile> read_profile(ImageView image, Point foot, Point outward, double search,
                                          bool rising) {
  NormalProfile profile;
  if (!ProfileReader(image, outward, search, rising).read(foot, profile)) return std::nullopt;
  return profile;
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
