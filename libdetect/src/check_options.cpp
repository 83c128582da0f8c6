#include "check_options.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "numerics/corner_search.h"

namespace tagmint::detect {
namespace {

/// Either way. The blur's 16-bit weights add up to one for as long as its kernel is far shorter
/// than 2^16; no picture of tags is left long before.
constexpr double kMaxBlurSigma_px = 100;
/// Far above any image's side, and its ring of pixels can still be counted.
constexpr double kMaxMinSide_px = 1e6;

void require(bool holds, std::string_view name, double value, std::string_view range) {
  if (holds) return;
  throw std::invalid_argument(
      fmt::format("detector option {} is {}; it must be {}", name, value, range));
}

}  // namespace

void check_options(const DetectorOptions& o) {
  const auto at_least = [](double value, double least) {
    return std::isfinite(value) && value >= least;
  };
  require(at_least(o.decimate, 1), "decimate", o.decimate, "at least 1");
  require(std::abs(o.blur_sigma_px) <= kMaxBlurSigma_px, "blur_sigma_px", o.blur_sigma_px,
          fmt::format("-{0} to {0}", kMaxBlurSigma_px));
  require(o.min_contrast >= 0 && o.min_contrast <= 255, "min_contrast", o.min_contrast, "0 to 255");
  require(o.min_cluster_points >= 4, "min_cluster_points", o.min_cluster_points, "at least 4");
  require(o.max_corner_candidates >= 4 && o.max_corner_candidates <= kMaxCornerCandidates,
          "max_corner_candidates", o.max_corner_candidates,
          fmt::format("4 to {}", kMaxCornerCandidates));
  require(at_least(o.max_line_fit_mse_px2, 0), "max_line_fit_mse_px2", o.max_line_fit_mse_px2,
          "at least 0");
  require(at_least(o.critical_angle_deg, 0) && o.critical_angle_deg < 90, "critical_angle_deg",
          o.critical_angle_deg, "at least 0 and below 90");
  require(at_least(o.min_side_px, 0) && o.min_side_px <= kMaxMinSide_px, "min_side_px",
          o.min_side_px, fmt::format("0 to {}", kMaxMinSide_px));
  require(at_least(o.decode_sharpening, 0), "decode_sharpening", o.decode_sharpening, "at least 0");
  require(at_least(o.min_decision_margin, 0), "min_decision_margin", o.min_decision_margin,
          "at least 0");
  require(std::isfinite(o.min_log_odds), "min_log_odds", o.min_log_odds, "finite");
  if (o.lens) check_camera(*o.lens);
  require(o.threads >= 0, "threads", o.threads, "at least 0");
}

}  // namespace tagmint::detect
