#include "refine/refine_photometric.h"

#include <algorithm>
#include <cmath>

#include "numerics/cholesky.h"
#include "refine/corner_map.h"
#include "tagmint/detect/homography.h"

namespace tagmint::detect {
namespace {

using Normal = Cholesky<kPhotometricParameters>;

/// Standard deviation of the point-spread to begin with, px: half a pixel of optics and the pixel.
constexpr double kFirstSpread_px = 0.65;
/// A pixel alone has 1 / sqrt(12).
constexpr double kLeastSpread_px = 0.29;
/// Beyond, a cell of any tag that can be read is smaller than the blur.
constexpr double kLargestSpread_px = 20;
/// How far the width may be from its first guess and the others from zero before the prior pulls as
/// hard as one pixel: keeps tags of few pixels from explaining noise by blur, light and tone.
constexpr double kLogSpreadPrior = 0.5;
constexpr double kLightPrior = 0.5;
constexpr double kTonePrior = 0.4;
/// Lenses have longer tails than the normal density, and the mean of sharp pictures is about this.
constexpr double kFirstTails = 0.3;
constexpr double kTailsPrior = 0.4;
constexpr double kLeastTails = -0.3, kMostTails = 1.5;
/// Of one step.
constexpr double kMaxLogSpreadStep = 0.5;
/// |tone| < 1 keeps the curve rising.
constexpr double kMaxTone = 0.8;
/// Pixels farther from the model than this share of the contrast, this many gray levels and so many
/// times the noise are outliers.
constexpr double kOutlierShare = 0.2;
constexpr double kOutlierLevels = 4;
constexpr double kOutlierNoise = 3;
/// Variance of a pixel's noise that is always there: rounding and what no model explains, gray
/// levels squared.
constexpr double kLeastVariance = 0.1;
/// Blocks of pixels that the first steps and the last judgement look at.
constexpr std::size_t kFewBlocks = 8;
/// Pixels are taken from both sides of an edge up to so many spreads.
constexpr double kNearSpreads = 2.6;
/// With a spread above this, pixels are chosen again, farther from the edges.
constexpr double kWideSpread_px = 0.95;
/// The nearest grid line alone counts while the spread is below this share of a cell, those of a
/// pixel's own cell below this: then others are 2.6 and 2.8 spreads away or farther.
constexpr double kWideCellShare = 0.19;
constexpr double kMiddlingCellShare = 0.36;
/// Fewer pixels than this, times the parameters, are too few.
constexpr std::size_t kLeastPixelsEach = 3;
/// A sum of squared residuals over some of the pixels may be larger by this many variances where
/// both places are equally good.
constexpr double kChance = 8;
/// Steps over all pixels end when no corner moves by more, px: the next would move it by some
/// hundredth of that.
constexpr double kStill_px = 0.08;
constexpr int kMaxFullSteps = 5;

int edges_for(double spread_cells) {
  if (spread_cells < kWideCellShare) return kWideCells;
  return spread_cells < kMiddlingCellShare ? kMiddlingCells : kSmallCells;
}

double spread_px(const PhotometricParameters& p) { return std::exp(p.log_spread); }

/// Mean gray of the black and of the white ring at the border square.
struct Levels {
  double black = 0;
  double white = 0;

  bool apart() const { return white > black; }
  /// Twice the brightness that is nearest.
  int brightness(double gray) const {
    const double share = (gray - black) / (white - black);
    return static_cast<int>(std::lround(2 * std::clamp(share, 0.0, 1.0)));
  }
};

/// Gray value of the pixel that a place is in.
std::optional<double> nearest_gray(ImageView image, Point p) {
  if (!(p.x >= 0 && p.y >= 0 && p.x < image.width && p.y < image.height)) return std::nullopt;
  return image.row(static_cast<int>(p.y))[static_cast<int>(p.x)];
}

template <typename Gray>
Levels ring_levels(const TagPattern& pattern, const Gray& gray) {
  std::array<double, 3> sum{};  // by brightness
  std::array<int, 3> count{};
  for (const int ring : {pattern.border_begin() - 1, pattern.border_begin()}) {
    const int last = pattern.width() - 1 - ring;
    const auto add = [&](int x, int y) {
      if (const std::optional<double> value = gray(x, y)) {
        sum[pattern.brightness(x, y)] += *value;
        ++count[pattern.brightness(x, y)];
      }
    };
    for (int i = ring; i < last; i += 2) add(i, ring), add(last, i), add(i, last), add(ring, i);
  }
  if (count[0] == 0 || count[2] == 0) return {};
  return {sum[0] / count[0], sum[2] / count[2]};
}

/// The state of one fit.
class Fit {
 public:
  Fit(ImageView image, const PhotometricOptions& options, PhotometricScratch& scratch)
      : image_(image), options_(options), scratch_(scratch) {}

  std::optional<PhotometricFit> run(const codec::Family& family, codec::TagId id,
                                    const Corners& corners);

 private:
  bool begin(const Corners& corners);
  void guess_unknown_cells();
  bool choose(double near_px);
  bool first_step();
  bool step(std::size_t block_step);
  bool solve(PhotometricSums& sums);
  void move(PhotometricVector step);
  bool agrees_better(const std::array<double, 8>& before);
  std::optional<PhotometricFit> result(const Corners& corners) const;
  std::optional<Corners> ideal_corners() const {
    return places_in_px(parameters_.to_cells, frame_, border_corners(scratch_.pattern));
  }
  PhotometricSums sums(const PhotometricParameters& at, std::size_t block_step, bool normal) const {
    return photometric_sums(
        scratch_.pixels, at, scratch_.pattern.edges(),
        {.outlier_scale = outlier_scale_, .block_step = block_step, .normal = normal});
  }
  std::size_t few() const {
    return std::max<std::size_t>(1, scratch_.pixels.blocks() / kFewBlocks);
  }

  ImageView image_;
  const PhotometricOptions& options_;
  PhotometricScratch& scratch_;
  TagFrame frame_;
  double cell_px_ = 1;
  Corners first_corners_;  // ideal px
  PhotometricParameters parameters_;
  double outlier_scale_ = 1e9;
  Normal factor_;
  double variance_ = 1;  // of a pixel about the model
  double moved_px_ = 0;  // by the last step, the farthest corner
};

/// Frame and first parameters; false for corners that are no tag's.
bool Fit::begin(const Corners& corners) {
  Point middle{0, 0};
  double perimeter = 0;
  for (int i = 0; i < 4; ++i) {
    first_corners_[i] = to_ideal_px(options_.lens, corners[i]);
    middle = middle + 0.25 * first_corners_[i];
    perimeter += length(corners[(i + 1) % 4] - corners[i]);
  }
  frame_.origin = middle;
  frame_.scale_px = 0;
  for (const Point p : first_corners_) {
    frame_.scale_px =
        std::max({frame_.scale_px, std::abs(p.x - middle.x), std::abs(p.y - middle.y)});
  }
  if (!(frame_.scale_px > 0)) return false;
  const TagPattern& pattern = scratch_.pattern;
  cell_px_ = perimeter / (4 * (pattern.border_end() - pattern.border_begin()));
  const auto map = map_to_cells(first_corners_, frame_, pattern);
  if (!map) return false;
  parameters_ = {};
  parameters_.to_cells = *map;
  parameters_.log_spread = std::log(kFirstSpread_px);
  parameters_.tails = kFirstTails;
  return true;
}

/// Cells around the tag, and those that it leaves open, have the colour that the picture shows in
/// their middle, rounded to black, gray or white: paper goes on, but nobody promised it.
void Fit::guess_unknown_cells() {
  TagPattern& pattern = scratch_.pattern;
  const auto& g = parameters_.to_cells;
  const std::optional<Homography> from_cells =
      Homography({g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], 1}).inverse();
  if (!from_cells) return;
  const auto gray = [&](int x, int y) {
    const Point place = frame_.to_px(from_cells->project({x + 0.5, y + 0.5}));
    return nearest_gray(image_, to_image_px(options_.lens, place));
  };
  const Levels levels = ring_levels(pattern, gray);
  if (!levels.apart()) return;
  const int width = pattern.width();
  for (int y = -1; y <= width; ++y) {
    for (int x = -1; x <= width; ++x) {
      if (pattern.is_known(x, y)) continue;
      if (const std::optional<double> value = gray(x, y)) {
        pattern.guess(x, y, levels.brightness(*value));
      }
    }
  }
}

/// Fills the list of pixels; false when they are too few.
bool Fit::choose(double near_px) {
  // Half as much again, because cells are not equally wide everywhere.
  const double inset =
      scratch_.pattern.plain_rim() ? std::max(0.0, 1 - 1.5 * near_px / cell_px_) : 0;
  const auto outer =
      places_in_px(parameters_.to_cells, frame_, outer_corners(scratch_.pattern, inset));
  if (!outer) return false;
  Corners region;
  for (int i = 0; i < 4; ++i) region[i] = to_image_px(options_.lens, (*outer)[i]);
  PixelChoice choice{.frame = frame_,
                     .to_cells = parameters_.to_cells,
                     .near_px = near_px,
                     .spread_px = spread_px(parameters_)};
  const auto area = static_cast<std::size_t>(std::abs(signed_area(region)));
  choice.step = static_cast<int>(
      std::max<std::size_t>(1, (area + options_.most_pixels / 2) / options_.most_pixels));
  PhotometricPixels& pixels = scratch_.pixels;
  pixels.reset(most_pixels(image_, region, choice.step));
  if (options_.lens) {
    const Point middle = to_image_px(options_.lens, frame_.origin);
    const Point right = to_ideal_px(options_.lens, middle + Point{1, 0}) - frame_.origin;
    const Point down = to_ideal_px(options_.lens, middle + Point{0, 1}) - frame_.origin;
    const PixelMapping mapping{[&](Point p) { return to_ideal_px(options_.lens, p); },
                               std::sqrt(std::abs(cross(right, down)))};
    scalar::choose_pixels(image_, scratch_.pattern, choice, region, &mapping, pixels);
  } else {
    choose_pixels(image_, scratch_.pattern, choice, region, pixels);
  }
  return pixels.size() >= kLeastPixelsEach * kPhotometricParameters;
}

/// Adds the priors, factors and moves; false when the matrix is not positive definite.
bool Fit::solve(PhotometricSums& sums) {
  variance_ =
      std::max(kLeastVariance, sums.squared / std::max(1.0, sums.weight - kPhotometricParameters));
  const auto prior = [&](int i, double distance, double deviation) {
    sums.normal[i][i] += variance_ / (deviation * deviation);
    sums.gradient[i] += variance_ / (deviation * deviation) * distance;
  };
  prior(kLogSpread, std::log(kFirstSpread_px) - parameters_.log_spread, kLogSpreadPrior);
  prior(kLightX, -parameters_.light_x, kLightPrior);
  prior(kLightY, -parameters_.light_y, kLightPrior);
  prior(kTails, kFirstTails - parameters_.tails, kTailsPrior);
  prior(kTone, -parameters_.tone, kTonePrior);
  if (!factor_.factor(sums.normal)) return false;
  move(factor_.solve(sums.gradient));
  return true;
}

void Fit::move(PhotometricVector step) {
  const std::optional<Corners> before = ideal_corners();
  step[kLogSpread] = std::clamp(step[kLogSpread], -kMaxLogSpreadStep, kMaxLogSpreadStep);
  parameters_ = moved(parameters_, step);
  parameters_.log_spread =
      std::clamp(parameters_.log_spread, std::log(kLeastSpread_px), std::log(kLargestSpread_px));
  parameters_.tails = std::clamp(parameters_.tails, kLeastTails, kMostTails);
  parameters_.tone = std::clamp(parameters_.tone, -kMaxTone, kMaxTone);
  const std::optional<Corners> after = ideal_corners();
  moved_px_ = 1e9;
  if (!before || !after) return;
  moved_px_ = 0;
  for (int i = 0; i < 4; ++i) {
    moved_px_ = std::max(moved_px_, length((*after)[i] - (*before)[i]));
  }
}

/// Black and contrast as the drawn tag fits them best, then a step of geometry and spread from the
/// same sums: those of contrast 1 and black 0 hold all that is needed. Light and tone wait.
bool Fit::first_step() {
  parameters_.black = 0;
  parameters_.contrast = 1;
  PhotometricSums s = sums(parameters_, few(), true);
  // Regression of gray on the share of white: columns kBlackLevel (1) and kContrast (share).
  const double n = s.normal[kBlackLevel][kBlackLevel];
  const double t = s.normal[kBlackLevel][kContrast];
  const double tt = s.normal[kContrast][kContrast];
  const double determinant = n * tt - t * t;
  if (!(determinant > 0)) return false;
  const double black = (tt * s.gradient[kBlackLevel] - t * s.gradient[kContrast]) / determinant;
  const double more = (n * s.gradient[kContrast] - t * s.gradient[kBlackLevel]) / determinant;
  parameters_.black = black;
  parameters_.contrast = 1 + more;
  if (!(parameters_.contrast > 1)) return false;
  outlier_scale_ = std::max(kOutlierLevels, kOutlierShare * parameters_.contrast);

  // What the sums would be: residuals are less by black + more * share, derivatives by the place
  // and the point-spread are `contrast` times as large.
  s.squared -= black * s.gradient[kBlackLevel] + more * s.gradient[kContrast];
  const auto column = [&](int a, int b) { return a <= b ? s.normal[a][b] : s.normal[b][a]; };
  PhotometricVector gradient = s.gradient;
  for (int a = 0; a < kPhotometricParameters; ++a) {
    gradient[a] -= black * column(a, kBlackLevel) + more * column(a, kContrast);
  }
  const auto factor = [&](int a) {
    return a < 8 || a == kLogSpread || a == kTails ? parameters_.contrast : 1;
  };
  const auto waits = [](int a) { return a == kLightX || a == kLightY || a == kTone; };
  for (int a = 0; a < kPhotometricParameters; ++a) {
    s.gradient[a] = waits(a) ? 0 : factor(a) * gradient[a];
    for (int b = a; b < kPhotometricParameters; ++b) {
      s.normal[a][b] *= factor(a) * factor(b);
      if (waits(a) || waits(b)) s.normal[a][b] = a == b ? 1 : 0;
    }
  }
  return solve(s);
}

bool Fit::step(std::size_t block_step) {
  PhotometricSums s = sums(parameters_, block_step, true);
  if (!solve(s)) return false;
  outlier_scale_ = std::max(
      {kOutlierLevels, kOutlierShare * parameters_.contrast, kOutlierNoise * std::sqrt(variance_)});
  return true;
}

/// Whether the picture is nearer to the result than to the tag at `before`, both with the light,
/// spread and tone of the result. Takes the variance at the result, where the last sums were from
/// the place before it.
bool Fit::agrees_better(const std::array<double, 8>& before) {
  const PhotometricSums after = sums(parameters_, few(), false);
  const auto pixels = static_cast<double>(scratch_.pixels.size());
  variance_ = std::max(kLeastVariance, after.squared / std::max(1.0, after.weight) * pixels /
                                           (pixels - kPhotometricParameters));
  PhotometricParameters old = parameters_;
  old.to_cells = before;
  return after.squared <= sums(old, few(), false).squared + kChance * variance_;
}

std::optional<PhotometricFit> Fit::result(const Corners& corners) const {
  const std::optional<Corners> ideal = ideal_corners();
  if (!ideal) return std::nullopt;
  if (spread_px(parameters_) < kLeastTrustedSpread_px) return std::nullopt;
  if (options_.noise) {
    const double by_noise = kMostNoise * std::max(0.5, *options_.noise);
    const double by_misfit = kMaxMisfit * parameters_.contrast;
    if (variance_ > by_noise * by_noise + by_misfit * by_misfit) return std::nullopt;
  }
  const double allowed =
      std::max({std::min(kMaxShift_px, kMaxShiftOfSmallCells * cell_px_),
                kMaxShiftOfLargeCells * cell_px_, kMaxShiftOfSpread * spread_px(parameters_)});
  PhotometricFit fit;
  for (int i = 0; i < 4; ++i) {
    fit.corners[i] = to_image_px(options_.lens, (*ideal)[i]);
    if (!(length(fit.corners[i] - corners[i]) <= allowed)) return std::nullopt;
  }
  const Matrix8 jacobian = lens_jacobian(options_.lens, *ideal) *
                           corner_jacobian(parameters_.to_cells, frame_, *ideal, scratch_.pattern);
  // With normal = L L^T, J normal^-1 J^T is X^T X for X = L^-1 J^T.
  std::array<PhotometricVector, 8> x;
  for (int corner = 0; corner < 8; ++corner) {
    PhotometricVector row{};
    for (int i = 0; i < 8; ++i) row[i] = jacobian(corner, i);
    x[corner] = factor_.solve_lower(row);
  }
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b <= a; ++b) {
      double product = 0;
      for (int i = 0; i < kPhotometricParameters; ++i) product += x[a][i] * x[b][i];
      fit.covariance[a * 8 + b] = fit.covariance[b * 8 + a] = variance_ * product;
    }
  }
  fit.parameters = parameters_;
  fit.noise = std::sqrt(variance_);
  return fit;
}

std::optional<PhotometricFit> Fit::run(const codec::Family& family, codec::TagId id,
                                       const Corners& corners) {
  scratch_.pattern.begin(family, id, options_.inverted, options_.mirrored);
  if (!begin(corners)) return std::nullopt;
  guess_unknown_cells();
  scratch_.pattern.finish(edges_for(kFirstSpread_px / cell_px_));
  if (!choose(kNearSpreads * kFirstSpread_px)) return std::nullopt;
  const std::array<double, 8> before = parameters_.to_cells;
  if (!first_step() || !step(few())) return std::nullopt;
  const int edges = edges_for(spread_px(parameters_) / cell_px_);
  if (edges > scratch_.pattern.edges() || spread_px(parameters_) > kWideSpread_px) {
    scratch_.pattern.finish(edges);
    if (!choose(kNearSpreads * spread_px(parameters_))) return std::nullopt;
  }
  for (int i = 0; i < kMaxFullSteps; ++i) {
    if (!step(1)) return std::nullopt;
    if (moved_px_ < kStill_px) break;
  }
  if (!agrees_better(before)) return std::nullopt;
  return result(corners);
}

}  // namespace

std::optional<PhotometricFit> refine_photometric(ImageView image, const codec::Family& family,
                                                 codec::TagId id, const Corners& corners,
                                                 const PhotometricOptions& options,
                                                 PhotometricScratch& scratch) {
  return Fit(image, options, scratch).run(family, id, corners);
}

bool refine_detection(ImageView image, Detection& detection, const PhotometricOptions& options,
                      PhotometricScratch& scratch) {
  PhotometricOptions of_print = options;
  of_print.inverted = detection.inverted;
  of_print.mirrored = detection.mirrored;
  // A mirrored tag's corner i is where an upright one has corner kMirror[i].
  constexpr std::array<int, 4> kMirror = {1, 0, 3, 2};
  const auto place = [&](int i) { return detection.mirrored ? kMirror[i] : i; };
  Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = detection.corners[place(i)];
  std::optional<PhotometricFit> fit =
      refine_photometric(image, *detection.family, detection.id, corners, of_print, scratch);
  if (!fit) return false;
  if (detection.mirrored) {
    const PhotometricFit upright = *fit;
    for (int i = 0; i < 4; ++i) fit->corners[i] = upright.corners[place(i)];
    for (int a = 0; a < 8; ++a) {
      for (int b = 0; b < 8; ++b) {
        fit->covariance[a * 8 + b] =
            upright.covariance[(2 * place(a / 2) + a % 2) * 8 + 2 * place(b / 2) + b % 2];
      }
    }
  }
  const std::optional<Homography> homography = Homography::from_corners(fit->corners);
  if (!homography) return false;
  detection.corners = fit->corners;
  detection.homography = *homography;
  detection.center = homography->project({0, 0});
  detection.corner_covariance = fit->covariance;
  return true;
}

}  // namespace tagmint::detect
