#include "scene/gaussian.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "scene/rows.h"

namespace tagmint::scene {
namespace {

/// The discrete Gaussian, not scaled; as many weights as do not vanish.
std::vector<double> discrete_gaussian(double sigma) {
  const double t = sigma * sigma;
  const auto radius = static_cast<std::size_t>(std::ceil(6.5 * sigma) + 8);
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
  return weights;
}

}  // namespace

std::vector<double> gaussian_weights(double sigma) {
  constexpr double kSampled = 0.8;  // from here on
  if (sigma == 0) return {1.0};
  std::vector<double> weights;
  if (sigma < kSampled) {
    weights = discrete_gaussian(sigma);
  } else {
    const int radius = static_cast<int>(std::ceil(5 * sigma));
    for (int n = 0; n <= radius; ++n) weights.push_back(std::exp(-n * n / (2 * sigma * sigma)));
  }
  double sum = weights[0];
  for (std::size_t n = 1; n < weights.size(); ++n) sum += 2 * weights[n];
  for (double& weight : weights) weight /= sum;
  while (weights.size() > 1 && weights.back() < 1e-10) weights.pop_back();
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

}  // namespace tagmint::scene
