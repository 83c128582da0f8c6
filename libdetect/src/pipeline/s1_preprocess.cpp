#include "pipeline/s1_preprocess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tagmint::detect {
namespace {

/// Kernels wider than this many sigma to a side would add less than half a gray level.
constexpr double kKernelSigmas = 3.0;

void check(const PreprocessOptions& options) {
  if (!std::isfinite(options.decimate) || options.decimate < 1) {
    throw std::invalid_argument(
        fmt::format("decimate is {}; it is a number of pixels, 1 or more", options.decimate));
  }
  if (!std::isfinite(options.blur_sigma_px)) {
    throw std::invalid_argument("blur_sigma_px is not finite");
  }
}

/// Working pixels that fit whole into `side` full pixels. The small addend keeps 3 / 1.5 = 2 from
/// being rounded down by the last bit.
int decimated_side(int side, double factor) { return static_cast<int>(side / factor + 1e-9); }

/// The pixels of [i factor, (i + 1) factor) along a side of `side` pixels.
PixelSpan span_of(int i, double factor, int side) {
  const double begin = i * factor, end = begin + factor;
  PixelSpan span;
  span.first = static_cast<int>(begin);
  // An end on a pixel edge, or beyond the side by rounding alone, belongs to the pixel before.
  span.last = std::min(static_cast<int>(std::ceil(end - 1e-9)), side) - 1;
  span.first_share = static_cast<float>(span.first + 1 - begin);
  span.last_share =
      span.last > span.first ? static_cast<float>(std::min(end - span.last, 1.0)) : 0.0f;
  return span;
}

/// Mean of whole blocks of factor x factor pixels: sums down the columns first, contiguous in
/// memory, then along the row.
void decimate_by_whole(ImageView full, int factor, std::vector<std::uint32_t>& sums, Image& out) {
  const int used_width = out.width() * factor;
  const std::uint32_t area = std::uint32_t(factor) * factor;
  sums.resize(used_width);
  for (int j = 0; j < out.height(); ++j) {
    std::fill(sums.begin(), sums.end(), 0);
    for (int k = 0; k < factor; ++k) {
      const std::uint8_t* row = full.row(j * factor + k);
      for (int x = 0; x < used_width; ++x) sums[x] += row[x];
    }
    std::uint8_t* target = out.row(j);
    const std::uint32_t* block = sums.data();
    for (int i = 0; i < out.width(); ++i, block += factor) {
      std::uint32_t sum = area / 2;
      for (int k = 0; k < factor; ++k) sum += block[k];
      target[i] = static_cast<std::uint8_t>(sum / area);
    }
  }
}

/// Mean over squares of factor x factor pixels that begin and end inside pixels; each pixel counts
/// by the area of its share. A factor above 1 that is no whole number spans at least two pixels,
/// or one where the two agree but for rounding.
void decimate_by_fraction(ImageView full, double factor, PreprocessScratch& scratch, Image& out) {
  std::vector<float>& sums = scratch.weighted_sums;
  std::vector<PixelSpan>& spans = scratch.spans;
  sums.resize(full.width);
  spans.resize(out.width());
  for (int i = 0; i < out.width(); ++i) spans[i] = span_of(i, factor, full.width);
  const float inverse_area = static_cast<float>(1.0 / (factor * factor));
  for (int j = 0; j < out.height(); ++j) {
    const PixelSpan rows = span_of(j, factor, full.height);
    std::fill(sums.begin(), sums.end(), 0.0f);
    for (int y = rows.first; y <= rows.last; ++y) {
      const std::uint8_t* row = full.row(y);
      const float share = y == rows.first  ? rows.first_share
                          : y == rows.last ? rows.last_share
                                           : 1.0f;
      const float weight = share * inverse_area;
      for (int x = 0; x < full.width; ++x) sums[x] += weight * row[x];
    }
    std::uint8_t* target = out.row(j);
    for (int i = 0; i < out.width(); ++i) {
      const PixelSpan span = spans[i];
      float sum = 0.5f + span.first_share * sums[span.first] + span.last_share * sums[span.last];
      for (int x = span.first + 1; x < span.last; ++x) sum += sums[x];
      target[i] = static_cast<std::uint8_t>(std::min(sum, 255.0f));
    }
  }
}

/// Weights of a sampled Gaussian, 2 radius + 1 of them, 16 fractional bits, adding up to one.
void gaussian_kernel(double sigma, std::vector<std::uint32_t>& kernel) {
  constexpr double kOne = 65536;
  const int radius = std::max(1, static_cast<int>(std::ceil(kKernelSigmas * sigma)));
  const auto density = [&](int i) { return std::exp(-0.5 * (i / sigma) * (i / sigma)); };
  double total = 0;
  for (int i = -radius; i <= radius; ++i) total += density(i);
  kernel.resize(2 * radius + 1);
  std::uint32_t others = 0;
  for (int i = -radius; i <= radius; ++i) {
    if (i == 0) continue;
    kernel[i + radius] = static_cast<std::uint32_t>(std::lround(density(i) / total * kOne));
    others += kernel[i + radius];
  }
  kernel[radius] = static_cast<std::uint32_t>(kOne) - others;
}

/// Convolves rows: `in` -> scratch.horizontal, 8.8 bits.
void blur_rows(ImageView in, PreprocessScratch& scratch) {
  const int width = in.width;
  const int taps = static_cast<int>(scratch.kernel.size());
  const int radius = taps / 2;
  scratch.padded_row.resize(std::size_t(width) + 2 * radius);
  scratch.sums.resize(width);
  scratch.horizontal.resize(std::size_t(width) * in.height);
  for (int y = 0; y < in.height; ++y) {
    const std::uint8_t* row = in.row(y);
    std::uint8_t* padded = scratch.padded_row.data();
    std::fill_n(padded, radius, row[0]);
    std::copy_n(row, width, padded + radius);
    std::fill_n(padded + radius + width, radius, row[width - 1]);
    std::fill(scratch.sums.begin(), scratch.sums.end(), 128);
    for (int k = 0; k < taps; ++k) {
      const std::uint32_t weight = scratch.kernel[k];
      for (int x = 0; x < width; ++x) scratch.sums[x] += weight * padded[x + k];
    }
    std::uint16_t* target = scratch.horizontal.data() + std::size_t(y) * width;
    for (int x = 0; x < width; ++x) target[x] = static_cast<std::uint16_t>(scratch.sums[x] >> 8);
  }
}

/// Convolves columns: scratch.horizontal -> `out`, rounded. The sum cannot pass 32 bits: 255 * 2^8
/// * 2^16 + 2^23 < 2^32.
void blur_columns(PreprocessScratch& scratch, Image& out) {
  const int width = out.width(), height = out.height();
  const int taps = static_cast<int>(scratch.kernel.size());
  for (int y = 0; y < height; ++y) {
    std::fill(scratch.sums.begin(), scratch.sums.end(), std::uint32_t{1} << 23);
    for (int k = 0; k < taps; ++k) {
      const int source_y = std::clamp(y + k - taps / 2, 0, height - 1);
      const std::uint16_t* row = scratch.horizontal.data() + std::size_t(source_y) * width;
      const std::uint32_t weight = scratch.kernel[k];
      for (int x = 0; x < width; ++x) scratch.sums[x] += weight * row[x];
    }
    std::uint8_t* target = out.row(y);
    for (int x = 0; x < width; ++x) target[x] = static_cast<std::uint8_t>(scratch.sums[x] >> 24);
  }
}

/// blurred = in + (in - blurred), within 0..255.
void sharpen(ImageView in, Image& blurred) {
  for (int y = 0; y < in.height; ++y) {
    const std::uint8_t* row = in.row(y);
    std::uint8_t* target = blurred.row(y);
    for (int x = 0; x < in.width; ++x) {
      target[x] = static_cast<std::uint8_t>(std::clamp(2 * row[x] - target[x], 0, 255));
    }
  }
}

}  // namespace

ImageView preprocess(ImageView full, const PreprocessOptions& options, PreprocessScratch& scratch,
                     Image& working) {
  check(options);
  ImageView current = full;
  if (options.decimate > 1) {
    working.resize(decimated_side(full.width, options.decimate),
                   decimated_side(full.height, options.decimate));
    if (options.decimate == std::floor(options.decimate) && !working.view().empty()) {
      decimate_by_whole(full, static_cast<int>(options.decimate), scratch.whole_sums, working);
    } else {
      decimate_by_fraction(full, options.decimate, scratch, working);
    }
    current = working;
  }
  if (options.blur_sigma_px != 0 && !current.empty()) {
    gaussian_kernel(std::abs(options.blur_sigma_px), scratch.kernel);
    blur_rows(current, scratch);
    scratch.blurred.resize(current.width, current.height);
    blur_columns(scratch, scratch.blurred);
    if (options.blur_sigma_px < 0) sharpen(current, scratch.blurred);
    std::swap(working, scratch.blurred);
    current = working;
  }
  return current;
}

}  // namespace tagmint::detect
