#include "scene/effects.h"

#include <algorithm>
#include <cmath>

#include "scene/counter_random.h"
#include "scene/rows.h"

namespace tagmint::scene {
namespace {

/// A Poisson number of the given mean from one random word. Few electrons are counted up the
/// distribution; many are the normal quantile with the Poisson's skewness [CornishFisher1938],
/// whose distribution is off by less than 1e-3.
double poisson(double mean, std::uint64_t word) {
  constexpr double kMany = 40;
  if (mean >= kMany) {
    const double z = standard_normal(word);
    return std::max(0.0, std::floor(mean + std::sqrt(mean) * z + (z * z - 1) / 6 + 0.5));
  }
  const double u = unit_interval(word);
  double probability = std::exp(-mean);
  double sum = probability;
  double count = 0;
  while (sum <= u && probability > 0) {
    count += 1;
    probability *= mean / count;
    sum += probability;
  }
  return count;
}

}  // namespace

void apply_shot_noise(double electrons_per_level, std::uint64_t seed, GrayPlane& plane) {
  if (electrons_per_level == 0) return;
  constexpr std::uint64_t kStream = 43;  // apart from those of noise, texture and clutter
  const std::uint64_t stream = mix_bits(seed) + kStream;
  for_each_row(plane.height, [&](int y) {
    float* row = plane.row(y);
    const std::uint64_t first = static_cast<std::uint64_t>(y) * plane.width;
    for (int x = 0; x < plane.width; ++x) {
      const double mean = std::max(0.0F, row[x]) * electrons_per_level;
      const double electrons = poisson(mean, random_word(stream, first + x));
      row[x] = static_cast<float>(electrons / electrons_per_level);
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
