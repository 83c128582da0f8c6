#include "scene/optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "scene/gaussian.h"
#include "scene/kernel.h"

namespace tagmint::scene {
namespace {

/// Samples along a pixel's side. Between samples the profile of an edge is straight, which is off
/// by its second derivative over 12 scale^2 at most: the widest blur that goes in all directions
/// decides.
int grid_scale(double narrow_sigma_px, const Effects& effects) {
  constexpr int kFinest = 8;
  const auto scale = [&](double samples) {
    return std::min(kFinest, static_cast<int>(std::ceil(samples)));
  };
  const double length_px = effects.motion_blur.length_px;
  int needed = 1;
  if (narrow_sigma_px > 0 || effects.defocus_px > 0) {
    needed = kFinest;
    if (narrow_sigma_px > 0) needed = std::min(needed, scale(2.5 / narrow_sigma_px));
    if (effects.defocus_px > 0) needed = std::min(needed, scale(5 / std::sqrt(effects.defocus_px)));
  } else if (length_px > 0) {
    // Motion leaves edges along it as sharp as they were: the grid must keep its line thin.
    needed = std::max(3, scale(8 / std::sqrt(length_px)));
  }
  // A kernel's memory goes with the square of its length.
  constexpr double kLongest = 3000;  // samples
  return std::clamp(static_cast<int>(kLongest / std::max(1.0, length_px)), 1, needed);
}

/// Each sample of the line's own `scale` ones, with `line` about it; their mean.
std::vector<float> over_pixel(const std::vector<double>& line, int scale) {
  const int radius = static_cast<int>(line.size()) - 1;
  std::vector<float> sum(static_cast<std::size_t>(2 * radius + scale));
  for (int own = 0; own < scale; ++own) {
    for (int k = -radius; k <= radius; ++k) {
      sum[static_cast<std::size_t>(own + radius + k)] +=
          static_cast<float>(line[static_cast<std::size_t>(std::abs(k))] / scale);
    }
  }
  return sum;
}

/// Rows of grid samples in the order in which pixels see them: for each of the `scale` samples of a
/// pixel a lane, in which pixel after pixel is next to one another. Beyond the ends of the picture
/// its last samples go on.
class Lanes {
 public:
  /// `first`, `size`: the columns that a pixel sees, from its own first one on.
  Lanes(int width, int scale, int first, int size)
      : scale_(scale), first_(first), pitch_(width + (size + scale - 1) / scale) {}

  std::size_t row_size() const { return static_cast<std::size_t>(pitch_) * scale_; }
  void fill(const float* row, int columns, float* lanes) const {
    for (int phase = 0; phase < scale_; ++phase) {
      float* lane = lanes + static_cast<std::size_t>(phase) * pitch_;
      for (int i = 0; i < pitch_; ++i) {
        lane[i] = row[std::clamp(i * scale_ + phase + first_, 0, columns - 1)];
      }
    }
  }
  /// Where pixel 0's sample `column` of those it sees is; those of the next pixels follow.
  std::size_t place(int column) const {
    return static_cast<std::size_t>(column % scale_) * pitch_ + column / scale_;
  }

 private:
  int scale_;
  int first_;
  int pitch_;
};

}  // namespace

PointSpread::PointSpread(const Effects& effects) {
  const double sigma_px = effects.blur_sigma_px < kWide_px ? effects.blur_sigma_px : 0;
  scale_ = grid_scale(sigma_px, effects);
  const std::vector<double> gaussian = gaussian_weights(sigma_px * scale_);
  if (effects.motion_blur.length_px == 0 && effects.defocus_px == 0) {
    line_ = over_pixel(gaussian, scale_);
    first_ = 1 - static_cast<int>(gaussian.size());
    size_ = static_cast<int>(line_.size());
    return;
  }
  Kernel kernel = separable_kernel(gaussian);
  if (effects.defocus_px > 0) kernel = combined(kernel, disc_kernel(effects.defocus_px, scale_));
  if (effects.motion_blur.length_px > 0) {
    kernel = combined(kernel, line_kernel(effects.motion_blur, scale_));
  }
  set_taps(kernel);
}

void PointSpread::set_taps(const Kernel& kernel) {
  first_ = -kernel.radius;
  size_ = kernel.side() + scale_ - 1;
  constexpr double kLeast = 1e-7;  // of a weight that counts
  double whole = 0;
  for (int row = 0; row < size_; ++row) {
    for (int column = 0; column < size_; ++column) {
      double sum = 0;
      for (int y = std::max(0, row - scale_ + 1); y <= std::min(row, kernel.side() - 1); ++y) {
        for (int x = std::max(0, column - scale_ + 1); x <= std::min(column, kernel.side() - 1);
             ++x) {
          sum += kernel.at(x - kernel.radius, y - kernel.radius);
        }
      }
      const double weight = sum / (scale_ * scale_);
      if (weight < kLeast) continue;
      taps_.push_back({row, column, static_cast<float>(weight)});
      whole += weight;
    }
  }
  for (Tap& tap : taps_) tap.weight = static_cast<float>(tap.weight / whole);
}

void PointSpread::expose(const GrayPlane& light, const Window& window, int begin, int end,
                         GrayPlane& picture, Scratch& samples) const {
  if (!line_.empty()) return expose_separably(light, window, begin, end, picture, samples);
  const Lanes lanes(window.width, scale_, first_, size_);
  samples.resize(lanes.row_size() * static_cast<std::size_t>(window.rows));
  for (int row = 0; row < window.rows; ++row) {
    lanes.fill(light.row(row), window.columns(), samples.data() + row * lanes.row_size());
  }
  // Some pixels at a time, so that their sums stay in registers over all taps.
  constexpr int kAtOnce = 32;
  std::vector<const float*> source(taps_.size());
  for (int y = begin; y < end; ++y) {
    for (std::size_t i = 0; i < taps_.size(); ++i) {
      const int row = y * scale_ + first_ + taps_[i].row - window.first_row;
      source[i] = samples.data() +
                  static_cast<std::size_t>(std::clamp(row, 0, window.rows - 1)) * lanes.row_size() +
                  lanes.place(taps_[i].column);
    }
    float* out = picture.row(y);
    for (int x = 0; x < window.width; x += kAtOnce) {
      const int count = std::min(kAtOnce, window.width - x);
      std::array<float, kAtOnce> sum{};
      if (count == kAtOnce) {
        for (std::size_t i = 0; i < taps_.size(); ++i) {
          const float* from = source[i] + x;
          for (int k = 0; k < kAtOnce; ++k) sum[k] += taps_[i].weight * from[k];
        }
      } else {
        for (std::size_t i = 0; i < taps_.size(); ++i) {
          for (int k = 0; k < count; ++k) sum[k] += taps_[i].weight * source[i][x + k];
        }
      }
      std::copy(sum.begin(), sum.begin() + count, out + x);
    }
  }
}

void PointSpread::expose_separably(const GrayPlane& light, const Window& window, int begin, int end,
                                   GrayPlane& picture, Scratch& samples) const {
  const Lanes lanes(window.width, scale_, first_, size_);
  std::vector<float> down(static_cast<std::size_t>(window.columns()));
  samples.resize(lanes.row_size());
  for (int y = begin; y < end; ++y) {
    std::fill(down.begin(), down.end(), 0.0F);
    for (int k = 0; k < size_; ++k) {
      const int row = y * scale_ + first_ + k - window.first_row;
      const float* source = light.row(std::clamp(row, 0, window.rows - 1));
      for (std::size_t x = 0; x < down.size(); ++x) down[x] += line_[k] * source[x];
    }
    lanes.fill(down.data(), window.columns(), samples.data());
    float* out = picture.row(y);
    std::fill(out, out + window.width, 0.0F);
    for (int k = 0; k < size_; ++k) {
      const float* source = samples.data() + lanes.place(k);
      for (int x = 0; x < window.width; ++x) out[x] += line_[k] * source[x];
    }
  }
}

}  // namespace tagmint::scene
