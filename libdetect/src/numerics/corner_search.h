#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "numerics/line_fit.h"

namespace tagmint::detect {

/// Most corner candidates that a search takes: C(32, 4) = 35960 combinations.
inline constexpr int kMaxCornerCandidates = 32;

/// Buffers that the corner search keeps from one contour to the next.
struct CornerScratch {
  std::vector<double> error;         ///< window fit error by point
  std::vector<double> smooth_error;  ///< the same, smoothed
  std::vector<int> peaks;
  std::vector<LineFit> sides;  ///< fit from candidate i to candidate j, row-major
};

/// Places of a closed contour where it bends: peaks of the error of a line fitted to the window of
/// points about each place, smoothed along the contour.
///   moments   prefix sums over the n points of the contour
///   most      the strongest peaks kept, >= 4
///   returns   indices in ascending order, in scratch.peaks; empty when n is too small for a window
///   source    [WangOlson2016, section III-D]
///   cost      O(n)
std::span<const int> find_corner_candidates(std::span<const LineMoments> moments, int most,
                                            CornerScratch& scratch);

/// Limits of the search for the best four corners.
struct CornerLimits {
  double max_mse_px2 = 10.0;     ///< of each side
  double max_corner_cosine = 1;  ///< |cos| of the angle between neighbouring sides
};

/// The four of the candidates between which lines fit best: smallest sum of squared distances.
struct BestCorners {
  std::array<LineFit, 4> sides;  ///< in contour order
  double mse = 0;                ///< over all points
};
///   candidates   ascending indices, at most kMaxCornerCandidates
///   returns      nothing when no four satisfy the limits
///   cost         2 C(k, 2) line fits, then C(k, 4) combinations less those cut early
std::optional<BestCorners> choose_corners(std::span<const LineMoments> moments,
                                          std::span<const int> candidates,
                                          const CornerLimits& limits, CornerScratch& scratch);

}  // namespace tagmint::detect
