#include "scene/effects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "scene/counter_random.h"
#include "scene/rows.h"

namespace tagmint::scene {
namespace {

/// One place of a kernel: the pixel (x + dx, y + dy) counts `weight`.
struct Tap {
  int dx = 0;
  int dy = 0;
  float weight = 0;
};

/// A line about (0, 0), as pixels: points along it, each shared between the four nearest pixels.
std::vector<Tap> line_taps(const MotionBlur& motion) {
  constexpr int kPointsPerPixel = 16;
  const double angle = motion.angle_deg * std::numbers::pi / 180;
  const double half_x = motion.length_px / 2 * std::cos(angle);
  const double half_y = motion.length_px / 2 * std::sin(angle);
  const int points = std::max(2, static_cast<int>(std::ceil(motion.length_px * kPointsPerPixel)));
  std::map<std::pair<int, int>, double> weights;  // by dy, dx
  for (int i = 0; i < points; ++i) {
    const double t = 2 * (i + 0.5) / points - 1;
    const double x = t * half_x, y = t * half_y;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const double fx = x - left, fy = y - top;
    weights[{top, left}] += (1 - fx) * (1 - fy);
    weights[{top, left + 1}] += fx * (1 - fy);
    weights[{top + 1, left}] += (1 - fx) * fy;
    weights[{top + 1, left + 1}] += fx * fy;
  }
  std::vector<Tap> taps;
  for (const auto& [place, weight] : weights) {
    if (weight > 0) {
      taps.push_back({place.second, place.first, static_cast<float>(weight / points)});
    }
  }
  return taps;
}

}  // namespace

void apply_motion_blur(const MotionBlur& motion, GrayPlane& plane) {
  if (motion.length_px == 0) return;
  const std::vector<Tap> taps = line_taps(motion);
  const GrayPlane still = plane;
  for_each_row(plane.height, [&](int y) {
    float* out = plane.row(y);
    std::fill(out, out + plane.width, 0.0F);
    for (const Tap& tap : taps) {
      const float* source = still.row(std::clamp(y + tap.dy, 0, plane.height - 1));
      for (int x = 0; x < plane.width; ++x) {
        out[x] += tap.weight * source[std::clamp(x + tap.dx, 0, plane.width - 1)];
      }
    }
  });
}

void apply_gamma(double gamma, GrayPlane& plane) {
  if (gamma == 1) return;
  for_each_row(plane.height, [&](int y) {
    float* row = plane.row(y);
    for (int x = 0; x < plane.width; ++x) {
      const double light = std::clamp(row[x] / 255.0, 0.0, 1.0);
      row[x] = static_cast<float>(255 * std::pow(light, 1 / gamma));
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
