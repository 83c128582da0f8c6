#include "tracker_path.h"

#include <algorithm>
#include <cmath>

#include "kernels/halve_kernels.h"
#include "numerics/bilinear.h"
#include "stage_timer.h"
#include "tracker/t1_noise_floor.h"

namespace tagmint::detect {
namespace {

/// Above this floor, gray levels, noise hides in single pixels whatever a tag is printed with.
constexpr int kMostFloor = 200;
/// Above this one bits of single pixels are too often wrong: the half-size picture has the ordinary
/// threshold for all contrasts then.
constexpr int kTrustedFloor = 90;
/// How much the contrast of noise alone, over the pixels of 3 x 3 tiles, adds to that of a tag:
/// about 5 standard deviations; half of that in the half-size picture.
constexpr double kHalfNoiseSpread = 2.5;

/// Tiles with less contrast hold no edge of a shadow across a tag in good light.
constexpr double kLeastShadowContrast = 50;

/// A quad of fainter sides, in floors, may be better at half the size.
constexpr double kTrustedContrast = 1.5;

/// Mean difference of the gray values on both sides of the middles of a quad's sides, gray levels.
///   scale   full pixels, which the quad is in, to one of the image
double edge_contrast(ImageView image, const Quad& quad, double scale) {
  constexpr double kAway = 1.5;  // px of the image: outside of a sharp edge's blur
  double sum = 0;
  int sides = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point from = (1 / scale) * quad.corners[i];
    const Point step = (1 / scale) * quad.corners[(i + 1) % 4] - from;
    const Point outward = (kAway / std::sqrt(dot(step, step))) * Point{-step.y, step.x};
    const Point middle = from + 0.5 * step;
    const auto outside = sample_bilinear(image, middle + outward);
    const auto inside = sample_bilinear(image, middle - outward);
    if (!outside || !inside) continue;
    sum += std::abs(*outside - *inside);
    ++sides;
  }
  return sides > 0 ? sum / sides : 0;
}

std::uint8_t gray_level(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

}  // namespace

TrackerPath::TrackerPath(const DetectorOptions& o, const QuadKinds& kinds)
    : options_(o),
      preprocess_options_{.decimate = o.decimate, .blur_sigma_px = o.blur_sigma_px},
      whole_search_(kinds),
      half_search_(kinds) {}

/// Mean of 2 x 2 pixels; an odd row or column at the end is left out.
ImageView TrackerPath::halved(ImageView image, WorkShare&, DetectStats& stats) {
  const StageTimer timer(stats, Stage::Preprocess);
  halved_.resize(image.width / 2, image.height / 2);
  for (int y = 0; y < halved_.height(); ++y) {
    halve_rows(image.row(2 * y), image.row(2 * y + 1), halved_.width(), halved_.row(y));
  }
  return halved_;
}

/// Adds the quads of a picture whose pixels are `scale` full ones wide.
void TrackerPath::search_at(ImageView image, double scale, ContrastRule contrast,
                            QuadSearch& search, const KnownQuads* known, WorkShare& share,
                            DetectStats& stats, DebugSink* debug) {
  const std::size_t before = quads_.size();
  search.run(image, contrast,
             {.min_side_px = options_.min_side_px / scale,
              .fit_edges = options_.refine_edges,
              .known = known},
             share, stats, debug, quads_);
  for (std::size_t i = before; i < quads_.size(); ++i) {
    for (Point& corner : quads_[i].corners) corner = scale * corner;
  }
}

std::span<const Quad> TrackerPath::find_quads(ImageView full, WorkShare& share, DetectStats& stats,
                                              DebugSink* debug) {
  ImageView working;
  {
    const StageTimer timer(stats, Stage::Preprocess);
    working = preprocess(full, preprocess_options_, preprocess_scratch_, preprocessed_);
  }
  if (debug) debug->preprocessed(working);
  double noise = 0;
  {
    const StageTimer timer(stats, Stage::NoiseFloor);
    if (options_.contrast_by_noise) noise = estimate_noise(working);
  }
  quads_.clear();
  const int floor = contrast_floor(noise, options_.min_contrast, 255);
  if (floor <= kMostFloor) {
    search_at(working, options_.decimate, {gray_level(floor), 255}, whole_search_, nullptr, share,
              stats, debug);
  }
  const int half_floor = contrast_floor(noise / 2, options_.min_contrast, 255);
  if (half_floor <= kMostFloor && working.width >= 2 && working.height >= 2) {
    const double scale = 2 * options_.decimate;
    trusted_.clear();
    for (const Quad& quad : quads_) {
      if (edge_contrast(working, quad, options_.decimate) >= kTrustedContrast * floor) {
        trusted_.push_back(quad);
      }
    }
    known_.assign(trusted_, scale);
    const double middle_up_to =
        floor <= kTrustedFloor ? std::max(kLeastShadowContrast, floor + kHalfNoiseSpread * noise)
                               : 255;
    search_at(halved(working, share, stats), scale,
              {gray_level(half_floor), gray_level(middle_up_to)}, half_search_, &known_, share,
              stats, nullptr);
  }
  stats.quads += static_cast<std::int64_t>(quads_.size());
  if (debug) debug->quads(corners_of(quads_));
  if (debug) debug->refined_quads(corners_of(quads_));
  return quads_;
}

}  // namespace tagmint::detect
