#include "tracker/t1_noise_floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tagmint::detect {
namespace {

/// Rows that are looked at, and every other stretch of them.
constexpr int kRows = 24;
constexpr int kStretch = 32;
/// The mean of |a - 2 b + c| is sqrt(6) sqrt(2 / pi) sigma for normal noise.
constexpr double kMeanOfUnitNoise = 1.9544;
/// Quantiles of the means over a stretch, as shares of their middle (measured on normal noise).
constexpr double kQuartileShare = 0.93;
constexpr double kTwentiethShare = 0.80;
/// Sums over a stretch are counted in steps of this many gray levels.
constexpr int kStep = 4;
constexpr int kSteps = 512;

/// Sum of the second differences' magnitudes over pixels[0..kStretch), or -1 where one of the
/// pixels is at the sensor's limit.
int sum_of_stretch(const std::uint8_t* pixels) {
  int sum = 0;
  std::uint8_t least = 255;
  std::uint8_t most = 0;
  for (int i = 0; i < kStretch; ++i) {
    sum += std::abs(pixels[i - 1] - 2 * pixels[i] + pixels[i + 1]);
    least = std::min(least, pixels[i]);
    most = std::max(most, pixels[i]);
  }
  return least == 0 || most == 255 ? -1 : sum;
}

/// Sums over stretches of a picture, counted in steps.
struct SumHistogram {
  std::array<int, kSteps> stretches{};
  int all = 0;

  /// Step below which at most `share` of the stretches lie.
  int quantile(double share) const {
    int below = 0;
    for (int step = 0; step < kSteps - 1; ++step) {
      below += stretches[static_cast<std::size_t>(step)];
      if (below > share * all) return step;
    }
    return kSteps - 1;
  }
};

SumHistogram count_sums(ImageView image) {
  SumHistogram histogram;
  const int step = std::max(1, image.height / kRows);
  for (int y = step / 2; y < image.height; y += step) {
    const std::uint8_t* row = image.row(y);
    for (int x = 1; x + kStretch < image.width; x += 2 * kStretch) {
      const int sum = sum_of_stretch(row + x);
      if (sum < 0) continue;
      ++histogram.stretches[static_cast<std::size_t>(std::min(sum / kStep, kSteps - 1))];
      ++histogram.all;
    }
  }
  return histogram;
}

double noise_of_step(int step, double share_of_middle) {
  if (step == 0) return 0;
  return (step + 0.5) * kStep / kStretch / kMeanOfUnitNoise / share_of_middle;
}

}  // namespace

double estimate_noise(ImageView image) {
  const SumHistogram histogram = count_sums(image);
  if (histogram.all == 0) return 0;
  return noise_of_step(histogram.quantile(0.25), kQuartileShare);
}

double estimate_calm_noise(ImageView image) {
  const SumHistogram histogram = count_sums(image);
  if (histogram.all == 0) return 0;
  return noise_of_step(histogram.quantile(0.05), kTwentiethShare);
}

int contrast_floor(double noise_sigma, int least, int most) {
  return std::clamp(static_cast<int>(std::lround(7 * noise_sigma + 3)), least, most);
}

}  // namespace tagmint::detect
