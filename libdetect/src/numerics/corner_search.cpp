#include "numerics/corner_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace tagmint::detect {
namespace {

/// Half a window is a twelfth of the contour, so that a window spans two thirds of a side of a
/// square, and 20 points at most, so that large quads keep sharp corners (as the reference
/// detector).
constexpr int kWindowsPerContour = 12;
constexpr int kMaxHalfWindow = 20;
/// Narrower windows than 5 points tell no corner from a step of the pixel grid.
constexpr int kMinHalfWindow = 2;

/// The error curve is smoothed by a Gaussian of one point's width, exp(-i^2 / 2) for |i| <= 3.
constexpr int kSmoothRadius = 3;
constexpr std::array<double, 2 * kSmoothRadius + 1> kSmooth = {
    0.0111089965, 0.1353352832, 0.6065306597, 1.0, 0.6065306597, 0.1353352832, 0.0111089965};

/// Error of the line through the window about each point of the contour, in out[kSmoothRadius + i];
/// the ends repeat the other end, as the contour is closed.
void window_errors(std::span<const LineMoments> moments, int half, std::vector<double>& out) {
  const int n = static_cast<int>(moments.size());
  out.resize(n + 2 * kSmoothRadius);
  double* error = out.data() + kSmoothRadius;
  for (int i = 0; i < n; ++i) {
    const int first = i >= half ? i - half : i - half + n;
    const int last = i + half < n ? i + half : i + half - n;
    error[i] = line_fit_mse(moments_between(moments, first, last));
  }
  for (int k = 0; k < kSmoothRadius; ++k) {
    out[k] = error[n - kSmoothRadius + k];
    error[n + k] = error[k];
  }
}

void smooth(std::span<const double> error, std::vector<double>& out) {
  const std::size_t n = error.size() - 2 * kSmoothRadius;
  out.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < kSmooth.size(); ++k) sum += kSmooth[k] * error[i + k];
    out[i] = sum;
  }
}

}  // namespace

std::span<const int> find_corner_candidates(std::span<const LineMoments> moments, int most,
                                            CornerScratch& scratch) {
  assert(most >= 4 && most <= kMaxCornerCandidates);
  std::vector<int>& peaks = scratch.peaks;
  peaks.clear();
  const int n = static_cast<int>(moments.size());
  const int half = std::min(kMaxHalfWindow, n / kWindowsPerContour);
  if (half < kMinHalfWindow) return peaks;
  window_errors(moments, half, scratch.error);
  smooth(scratch.error, scratch.smooth_error);

  const std::vector<double>& curve = scratch.smooth_error;
  for (int i = 0; i < n; ++i) {
    const double before = curve[i > 0 ? i - 1 : n - 1], after = curve[i + 1 < n ? i + 1 : 0];
    if (curve[i] > before && curve[i] >= after) peaks.push_back(i);
  }
  if (std::ssize(peaks) > most) {
    const auto stronger = [&](int a, int b) {
      return curve[a] != curve[b] ? curve[a] > curve[b] : a < b;
    };
    std::nth_element(peaks.begin(), peaks.begin() + most, peaks.end(), stronger);
    peaks.resize(most);
    std::sort(peaks.begin(), peaks.end());
  }
  return peaks;
}

namespace {

/// Lines between all pairs of candidates; combinations of four then only look them up.
class SideTable {
 public:
  SideTable(std::span<const LineMoments> moments, std::span<const int> candidates,
            const CornerLimits& limits, std::vector<LineFit>& sides)
      : limits_(limits), count_(static_cast<int>(candidates.size())), sides_(sides) {
    sides_.resize(candidates.size() * candidates.size());
    for (int i = 0; i < count_; ++i) {
      for (int j = 0; j < count_; ++j) {
        if (i == j) continue;
        const LineMoments sum = moments_between(moments, candidates[i], candidates[j]);
        sides_[i * count_ + j] = fit_line(sum);
        error_[i][j] = sides_[i * count_ + j].mse * sum.w;
      }
    }
  }

  const LineFit& side(int i, int j) const { return sides_[i * count_ + j]; }
  /// Weighted sum of squared distances.
  double error(int i, int j) const { return error_[i][j]; }
  bool straight(int i, int j) const { return side(i, j).mse <= limits_.max_mse_px2; }
  /// Whether side i..j turns enough into side j..k.
  bool bends(int i, int j, int k) const {
    return std::abs(dot(side(i, j).normal, side(j, k).normal)) <= limits_.max_corner_cosine;
  }

 private:
  const CornerLimits& limits_;
  int count_;
  std::vector<LineFit>& sides_;
  std::array<std::array<double, kMaxCornerCandidates>, kMaxCornerCandidates> error_;
};

}  // namespace

std::optional<BestCorners> choose_corners(std::span<const LineMoments> moments,
                                          std::span<const int> candidates,
                                          const CornerLimits& limits, CornerScratch& scratch) {
  const int n = static_cast<int>(candidates.size());
  assert(n <= kMaxCornerCandidates);
  const SideTable table(moments, candidates, limits, scratch.sides);
  double best = std::numeric_limits<double>::infinity();
  std::array<int, 4> chosen{};
  for (int a = 0; a + 3 < n; ++a) {
    for (int b = a + 1; b + 2 < n; ++b) {
      if (!table.straight(a, b) || table.error(a, b) >= best) continue;
      for (int c = b + 1; c + 1 < n; ++c) {
        const double two_sides = table.error(a, b) + table.error(b, c);
        if (!table.straight(b, c) || two_sides >= best || !table.bends(a, b, c)) continue;
        for (int d = c + 1; d < n; ++d) {
          const double all_sides = two_sides + table.error(c, d) + table.error(d, a);
          if (all_sides >= best || !table.straight(c, d) || !table.straight(d, a)) continue;
          if (!table.bends(b, c, d) || !table.bends(c, d, a) || !table.bends(d, a, b)) continue;
          best = all_sides;
          chosen = {a, b, c, d};
        }
      }
    }
  }
  if (!std::isfinite(best)) return std::nullopt;
  BestCorners result;
  double weight = 0;
  for (int i = 0; i < 4; ++i) {
    const int from = chosen[i], to = chosen[(i + 1) % 4];
    result.sides[i] = table.side(from, to);
    weight += moments_between(moments, candidates[from], candidates[to]).w;
  }
  result.mse = best / weight;
  return result;
}

}  // namespace tagmint::detect
