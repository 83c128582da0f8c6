#include "scene/background.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/clutter.h"
#include "scene/counter_random.h"

namespace tagmint::scene {
namespace {

/// A number in [-1, 1) for each point of a lattice.
double lattice_value(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  const auto index = static_cast<std::uint64_t>(y) * 0x100000001ULL + static_cast<std::uint64_t>(x);
  return 2 * unit_interval(random_word(seed, index)) - 1;
}

/// 0 at 0, 1 at 1, flat at both: the weights of a smooth join between lattice points.
double smooth_step(double t) { return t * t * (3 - 2 * t); }

/// Lattice noise with blobs of `scale` pixels at one place.
double value_noise(std::uint64_t seed, double x, double y, double scale) {
  const double u = std::floor(x / scale);
  const double v = std::floor(y / scale);
  const double a = smooth_step(x / scale - u);
  const double b = smooth_step(y / scale - v);
  const auto i = static_cast<std::int64_t>(u);
  const auto j = static_cast<std::int64_t>(v);
  const double top = (1 - a) * lattice_value(seed, i, j) + a * lattice_value(seed, i + 1, j);
  const double bottom =
      (1 - a) * lattice_value(seed, i, j + 1) + a * lattice_value(seed, i + 1, j + 1);
  return (1 - b) * top + b * bottom;
}

GrayPlane draw(const PlainBackground& plain, int width, int height, std::uint64_t) {
  return GrayPlane(width, height, static_cast<float>(plain.gray));
}

GrayPlane draw(const GradientBackground& gradient, int width, int height, std::uint64_t) {
  GrayPlane plane(width, height);
  const Ramp ramp(width, height, gradient.angle_deg);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double t = ramp.at(x, y);
      plane.row(y)[x] = static_cast<float>((1 - t) * gradient.from + t * gradient.to);
    }
  }
  return plane;
}

GrayPlane draw(const TextureBackground& texture, int width, int height, std::uint64_t seed) {
  constexpr int kOctaves = 4;
  GrayPlane plane(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      double weight = 0;
      for (int octave = 0; octave < kOctaves; ++octave) {
        const double share = std::ldexp(1.0, -octave);
        const double scale = std::max(1.0, texture.scale_px * share);
        // The octaves are streams of their own, all apart from the noise's stream.
        sum += share * value_noise(mix_bits(seed) + octave + 1, x + 0.5, y + 0.5, scale);
        weight += share;
      }
      const double level = texture.gray + texture.amplitude * sum / weight;
      plane.row(y)[x] = static_cast<float>(std::clamp(level, 0.0, 255.0));
    }
  }
  return plane;
}

GrayPlane draw(const ClutterBackground& clutter, int width, int height, std::uint64_t seed) {
  return draw_clutter(clutter, width, height, seed);
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
  for (int y = 0; y < image.height(); ++y) {
    const std::uint8_t* source = image.row(y);
    for (int x = 0; x < width; ++x) {
      const Tap& tap = across[static_cast<std::size_t>(x)];
      float sum = 0;
      for (std::size_t k = 0; k < tap.weights.size(); ++k) {
        sum += tap.weights[k] * source[static_cast<std::size_t>(tap.first) + k];
      }
      narrow.row(y)[x] = sum;
    }
  }
  GrayPlane plane(width, height);
  for (int y = 0; y < height; ++y) {
    const Tap& tap = down[static_cast<std::size_t>(y)];
    for (std::size_t k = 0; k < tap.weights.size(); ++k) {
      const float* source = narrow.row(tap.first + static_cast<int>(k));
      for (int x = 0; x < width; ++x) plane.row(y)[x] += tap.weights[k] * source[x];
    }
  }
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
  offset_ = 0.5 + (0.5 - width / 2.0) * per_x_ + (0.5 - height / 2.0) * per_y_;
}

GrayPlane draw_background(const Background& background, int width, int height, std::uint64_t seed) {
  return std::visit([&](const auto& kind) { return draw(kind, width, height, seed); }, background);
}

}  // namespace tagmint::scene
