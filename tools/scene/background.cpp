#include "scene/background.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "scene/clutter.h"
#include "scene/counter_random.h"
#include "scene/rows.h"

namespace tagmint::scene {
namespace {

/// A number in [-1, 1) for each point of a lattice.
double lattice_value(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  const auto index = static_cast<std::uint64_t>(y) * 0x100000001ULL + static_cast<std::uint64_t>(x);
  return 2 * unit_interval(random_word(seed, index)) - 1;
}

/// 0 at 0, 1 at 1, flat at both: the weights of a smooth join between lattice points.
double smooth_step(double t) { return t * t * (3 - 2 * t); }

/// Adds `share` of lattice noise with blobs of `scale` pixels to the row of pixel centres at y.
void add_value_noise(std::uint64_t seed, double y, double scale, double share,
                     std::vector<double>& row) {
  const double v = std::floor(y / scale);
  const double b = smooth_step(y / scale - v);
  const auto j = static_cast<std::int64_t>(v);
  const auto column = [&](std::int64_t i) {
    return (1 - b) * lattice_value(seed, i, j) + b * lattice_value(seed, i, j + 1);
  };
  std::int64_t i = 0;
  double left = column(0), right = column(1);
  for (std::size_t x = 0; x < row.size(); ++x) {
    const double at = (static_cast<double>(x) + 0.5) / scale;
    for (; i + 1 <= at; ++i) left = std::exchange(right, column(i + 2));
    const double a = smooth_step(at - static_cast<double>(i));
    row[x] += share * ((1 - a) * left + a * right);
  }
}

GrayPlane draw(const PlainBackground& plain, int width, int height, std::uint64_t) {
  return GrayPlane(width, height, static_cast<float>(plain.gray));
}

GrayPlane draw(const GradientBackground& gradient, int width, int height, std::uint64_t) {
  GrayPlane plane(width, height);
  const Ramp ramp(width, height, gradient.angle_deg);
  for_each_row(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const double t = ramp.at(x + 0.5, y + 0.5);
      plane.row(y)[x] = static_cast<float>((1 - t) * gradient.from + t * gradient.to);
    }
  });
  return plane;
}

GrayPlane draw(const TextureBackground& texture, int width, int height, std::uint64_t seed) {
  constexpr int kOctaves = 4;
  GrayPlane plane(width, height);
  for_each_row(height, [&](int y) {
    std::vector<double> sum(static_cast<std::size_t>(width));
    double weight = 0;
    for (int octave = 0; octave < kOctaves; ++octave) {
      const double share = std::ldexp(1.0, -octave);
      const double scale = std::max(1.0, texture.scale_px * share);
      // The octaves are streams of their own, all apart from the noise's stream.
      add_value_noise(mix_bits(seed) + octave + 1, y + 0.5, scale, share, sum);
      weight += share;
    }
    for (int x = 0; x < width; ++x) {
      const double level = texture.gray + texture.amplitude * sum[x] / weight;
      plane.row(y)[x] = static_cast<float>(std::clamp(level, 0.0, 255.0));
    }
  });
  return plane;
}

/// Its shapes cover all of it.
GrayPlane draw(const ClutterBackground&, int width, int height, std::uint64_t) {
  return GrayPlane(width, height);
}

/// Source samples that one destination sample is the mean of, and their weights: a tent as wide as
/// the larger of a source and a destination pixel.
struct Tap {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Tap> resampling_taps(int source, int destination, double source_per_destination,
                                 double source_begin) {
  const double reach = std::max(1.0, source_per_destination);
  std::vector<Tap> taps(static_cast<std::size_t>(destination));
  for (int i = 0; i < destination; ++i) {
    const double centre = source_begin + (i + 0.5) * source_per_destination;
    const int first = std::clamp(static_cast<int>(std::ceil(centre - reach - 0.5)), 0, source - 1);
    const int last =
        std::clamp(static_cast<int>(std::floor(centre + reach - 0.5)), first, source - 1);
    Tap& tap = taps[static_cast<std::size_t>(i)];
    tap.first = first;
    double sum = 0;
    for (int s = first; s <= last; ++s) {
      const double weight = std::max(1e-6, 1 - std::abs(s + 0.5 - centre) / reach);
      tap.weights.push_back(static_cast<float>(weight));
      sum += weight;
    }
    for (float& weight : tap.weights) weight /= static_cast<float>(sum);
  }
  return taps;
}

GrayPlane draw(const PhotoBackground& photo, int width, int height, std::uint64_t) {
  const detect::Image& image = photo.image;
  const double scale = std::min(static_cast<double>(image.width()) / width,
                                static_cast<double>(image.height()) / height);
  const auto across =
      resampling_taps(image.width(), width, scale, (image.width() - scale * width) / 2);
  const auto down =
      resampling_taps(image.height(), height, scale, (image.height() - scale * height) / 2);
  GrayPlane narrow(width, image.height());
  for_each_row(image.height(), [&](int y) {
    const std::uint8_t* source = image.row(y);
    for (int x = 0; x < width; ++x) {
      const Tap& tap = across[static_cast<std::size_t>(x)];
      float sum = 0;
      for (std::size_t k = 0; k < tap.weights.size(); ++k) {
        sum += tap.weights[k] * source[static_cast<std::size_t>(tap.first) + k];
      }
      narrow.row(y)[x] = sum;
    }
  });
  GrayPlane plane(width, height);
  for_each_row(height, [&](int y) {
    const Tap& tap = down[static_cast<std::size_t>(y)];
    for (std::size_t k = 0; k < tap.weights.size(); ++k) {
      const float* source = narrow.row(tap.first + static_cast<int>(k));
      for (int x = 0; x < width; ++x) plane.row(y)[x] += tap.weights[k] * source[x];
    }
  });
  return plane;
}

}  // namespace

Ramp::Ramp(int width, int height, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  // Half the image's extent along the direction; both ends are corners of the image.
  const double half = (std::abs(dx) * width + std::abs(dy) * height) / 2;
  per_x_ = dx / (2 * half);
  per_y_ = dy / (2 * half);
  offset_ = 0.5 - width / 2.0 * per_x_ - height / 2.0 * per_y_;
}

GrayPlane draw_background(const Background& background, int width, int height, std::uint64_t seed) {
  return std::visit([&](const auto& kind) { return draw(kind, width, height, seed); }, background);
}

std::vector<Patch> background_patches(const Background& background, int width, int height,
                                      std::uint64_t seed) {
  const auto* clutter = std::get_if<ClutterBackground>(&background);
  return clutter ? clutter_patches(*clutter, width, height, seed) : std::vector<Patch>{};
}

}  // namespace tagmint::scene
