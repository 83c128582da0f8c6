#include "scene/effects.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "scene/background.h"
#include "scene/counter_random.h"

namespace tagmint::scene {
namespace {

/// Calls work(y) for each row, on several threads.
template <typename Work>
void for_each_row(int height, Work work) {
  constexpr int kRowsAtOnce = 16;
  tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsAtOnce), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) work(y);
  });
}

}  // namespace

void apply_shading(const Shading& shading, GrayPlane& plane) {
  if (shading.strength == 0) return;
  const Ramp ramp(plane.width, plane.height, shading.angle_deg);
  for_each_row(plane.height, [&](int y) {
    float* row = plane.row(y);
    for (int x = 0; x < plane.width; ++x) {
      row[x] *= static_cast<float>(1 - shading.strength * ramp.at(x, y));
    }
  });
}

std::vector<double> gaussian_weights(double sigma_px) {
  if (sigma_px == 0) return {1.0};
  const double t = sigma_px * sigma_px;
  const auto radius = static_cast<std::size_t>(std::ceil(6.5 * sigma_px) + 8);
  // I_{n-1} = I_{n+1} + (2 n / t) I_n is stable downwards [Miller's algorithm]; start well beyond
  // the radius with any small number, then scale so that the sum is 1.
  const std::size_t start = 2 * radius + 16;
  std::vector<double> weights(start + 2, 0.0);
  weights[start] = 1e-300;
  for (std::size_t n = start; n > 0; --n) {
    weights[n - 1] = weights[n + 1] + 2.0 * static_cast<double>(n) / t * weights[n];
    if (weights[n - 1] > 1e200) {
      for (double& weight : weights) weight *= 1e-200;
    }
  }
  weights.resize(radius + 1);
  double sum = weights[0];
  for (std::size_t n = 1; n <= radius; ++n) sum += 2 * weights[n];
  for (double& weight : weights) weight /= sum;
  while (weights.size() > 1 && weights.back() < 1e-12) weights.pop_back();
  return weights;
}

void apply_blur(double sigma_px, GrayPlane& plane) {
  if (sigma_px == 0) return;
  const std::vector<double> exact = gaussian_weights(sigma_px);
  const std::vector<float> weights(exact.begin(), exact.end());
  const int radius = static_cast<int>(weights.size()) - 1;
  GrayPlane across(plane.width, plane.height);
  for_each_row(plane.height, [&](int y) {
    // The row with `radius` copies of its end pixels on both sides.
    std::vector<float> padded(static_cast<std::size_t>(plane.width) + 2 * radius);
    const float* source = plane.row(y);
    std::copy(source, source + plane.width, padded.begin() + radius);
    std::fill(padded.begin(), padded.begin() + radius, source[0]);
    std::fill(padded.end() - radius, padded.end(), source[plane.width - 1]);
    float* out = across.row(y);
    const float* middle = padded.data() + radius;
    for (int x = 0; x < plane.width; ++x) out[x] = weights[0] * middle[x];
    for (int k = 1; k <= radius; ++k) {
      for (int x = 0; x < plane.width; ++x) {
        out[x] += weights[k] * (middle[x - k] + middle[x + k]);
      }
    }
  });
  for_each_row(plane.height, [&](int y) {
    float* out = plane.row(y);
    const float* middle = across.row(y);
    for (int x = 0; x < plane.width; ++x) out[x] = weights[0] * middle[x];
    for (int k = 1; k <= radius; ++k) {
      const float* above = across.row(std::max(0, y - k));
      const float* below = across.row(std::min(plane.height - 1, y + k));
      for (int x = 0; x < plane.width; ++x) out[x] += weights[k] * (above[x] + below[x]);
    }
  });
}

detect::Image add_noise_and_round(const GrayPlane& plane, double sigma, std::uint64_t seed) {
  detect::Image image(plane.width, plane.height);
  for_each_row(plane.height, [&](int y) {
    const float* source = plane.row(y);
    std::uint8_t* out = image.row(y);
    const std::uint64_t first = static_cast<std::uint64_t>(y) * plane.width;
    for (int x = 0; x < plane.width; ++x) {
      double level = source[x];
      if (sigma > 0) level += sigma * standard_normal(random_word(seed, first + x));
      out[x] = static_cast<std::uint8_t>(std::clamp(std::floor(level + 0.5), 0.0, 255.0));
    }
  });
  return image;
}

}  // namespace tagmint::scene
