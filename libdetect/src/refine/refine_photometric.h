#pragma once

#include <optional>

#include "refine/choose_pixels.h"
#include "refine/photometric_sums.h"
#include "tagmint/detect/camera.h"
#include "tagmint/detect/detection.h"

namespace tagmint::detect {

struct PhotometricOptions {
  /// The lens through which straight sides look curved; without it they are taken for straight.
  std::optional<Camera> lens = {};
  bool inverted = false;  ///< the tag is printed with black for white
  bool mirrored = false;  ///< the tag is printed left for right; corners are those of the picture
                          ///< of an upright tag in the same place
  /// Standard deviation of the picture's noise, gray levels, where it is known: a fit that is off
  /// by much more is one of something else than a flat tag, such as of one that a lens curves.
  std::optional<double> noise = {};
  /// Pixels looked at in a tag; of larger tags some are left out. Measured: docs/refinement.md.
  std::size_t most_pixels = 1500;
};

/// What a tag's gray values say about it.
struct PhotometricFit {
  Corners corners;  ///< image px, in the order of kTagCorners
  CornerCovariance covariance{};
  PhotometricParameters parameters;
  double noise = 0;  ///< standard deviation of a pixel about the model, gray levels
};

/// Buffers kept from one tag to the next; one for each thread.
struct PhotometricScratch {
  TagPattern pattern;
  PhotometricPixels pixels;
};

/// Corners from all edges of a tag whose word is known: the homography, the light, the width of the
/// point-spread and the tone curve for which the drawn tag looks most like the picture, by
/// Gauss-Newton with weights that let go of outliers.
///   corners   near the truth, within about half a cell; image px, order of kTagCorners
///   returns   nothing where the picture does not agree better with the result than with `corners`,
///             the result is farther from them than kMaxShift* allow, or the picture is off the
///             result by more than noise and kMaxMisfit explain, or is sharper than a lens makes it
///   cost      7 to 9 us (docs/refinement.md)
std::optional<PhotometricFit> refine_photometric(ImageView image, const codec::Family& family,
                                                 codec::TagId id, const Corners& corners,
                                                 const PhotometricOptions& options,
                                                 PhotometricScratch& scratch);

/// Gives a detection the corners that refine_photometric() finds, and what follows from them;
/// leaves it as it is where there are none.
///   returns   whether there were some
bool refine_detection(ImageView image, Detection& detection, const PhotometricOptions& options,
                      PhotometricScratch& scratch);

/// A corner may move by a pixel, but not by more than half a cell where cells are small, and by a
/// tenth of a cell where they are large, or by as far as half the spread of the point-spread: the
/// wider the blur, the farther off are corners from the border alone.
inline constexpr double kMaxShift_px = 1.0;
/// Share of the contrast by which pixels may be off the model (rms), beside so many times the
/// noise. Pictures that the model fits are off by 0.01, by 0.02 to 0.045 at tilts of 75 and 80
/// degrees; glare and curved sides mostly by more, and there edges alone are truer.
inline constexpr double kMaxMisfit = 0.045;
inline constexpr double kMostNoise = 1.5;
/// A pixel alone spreads by 0.29 px. Pictures hardly wider, drawn or sharpened ones, have the
/// box's profile or overshoot, not the model's; lenses give 0.55 and more.
inline constexpr double kLeastTrustedSpread_px = 0.42;
inline constexpr double kMaxShiftOfSpread = 0.5;
inline constexpr double kMaxShiftOfSmallCells = 0.5;
inline constexpr double kMaxShiftOfLargeCells = 0.1;

}  // namespace tagmint::detect
