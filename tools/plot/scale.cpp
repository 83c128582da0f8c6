#include "plot/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tagmint::plot {
namespace {

constexpr double kMostTicks = 7;
/// A logarithmic axis of at most so many decades has lines at 2 and 5 too.
constexpr double kFineDecades = 2.5;

/// 1, 2 or 5 times a power of ten, so that at most `parts` of them fit into `range`.
double round_step(double range, double parts) {
  const double raw = range / parts;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::string number_text(double value) {
  if (value != 0 && (std::abs(value) >= 1e5 || std::abs(value) < 1e-3)) {
    const double power = std::floor(std::log10(std::abs(value)) + 1e-9);
    const double factor = value / std::pow(10.0, power);
    return std::abs(factor - 1) < 1e-6 ? fmt::format("1e{:.0f}", power)
                                       : fmt::format("{:.3g}e{:.0f}", factor, power);
  }
  return fmt::format("{:.4g}", value);
}

}  // namespace

Scale::Scale(const Axis& axis, const std::vector<double>& values) : logarithmic_(axis.logarithmic) {
  if (!axis.categories.empty()) {
    fit_categories(axis);
    return;
  }
  double least = 0, most = 0;
  bool any = false;
  for (const double value : values) {
    if (!can_show(value)) continue;
    least = any ? std::min(least, value) : value;
    most = any ? std::max(most, value) : value;
    any = true;
  }
  if (!any) {
    least = axis.logarithmic ? 1 : 0;
    most = axis.logarithmic ? 10 : 1;
  }
  if (axis.logarithmic) {
    fit_logarithmic(axis, least, most);
  } else {
    fit_linear(axis, least, most);
  }
}

bool Scale::can_show(double value) const {
  return std::isfinite(value) && (!logarithmic_ || value > 0);
}

double Scale::share(double value) const {
  if (!logarithmic_) return (value - low_) / (high_ - low_);
  return std::log(value / low_) / std::log(high_ / low_);
}

void Scale::fit_linear(const Axis& axis, double least, double most) {
  least = axis.low.value_or(least);
  most = axis.high.value_or(most);
  if (most <= least) most = least + (least == 0 ? 1 : std::abs(least));
  const double step = round_step(most - least, kMostTicks);
  low_ = axis.low.value_or(std::floor(least / step + 1e-9) * step);
  high_ = axis.high.value_or(std::ceil(most / step - 1e-9) * step);
  for (double i = std::ceil(low_ / step - 1e-9); i * step <= high_ + 1e-9 * step; ++i) {
    const double value = i * step + 0.0;  // no -0
    ticks_.push_back({value, number_text(value)});
  }
}

void Scale::fit_logarithmic(const Axis& axis, double least, double most) {
  least = axis.low.value_or(least);
  most = std::max(axis.high.value_or(most), least * (1 + 1e-9));
  const auto power_below = [](double value) { return std::floor(std::log10(value) + 1e-9); };
  // Rounded outwards to 1, 2 or 5 times a power of ten.
  const auto rounded = [&](double value, bool up) {
    const double power = std::pow(10.0, power_below(value));
    double best = up ? 10 * power : power;
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double at = factor * power;
      if (up && at >= value * (1 - 1e-9)) best = std::min(best, at);
      if (!up && at <= value * (1 + 1e-9)) best = std::max(best, at);
    }
    return best;
  };
  low_ = axis.low.value_or(rounded(least, false));
  high_ = axis.high.value_or(rounded(most, true));
  if (high_ < 2 * low_) high_ = 2 * low_;
  const double decades = std::log10(high_ / low_);
  const double every = std::max(1.0, std::ceil(decades / kMostTicks));
  for (double power = power_below(low_); power <= power_below(high_); ++power) {
    for (int factor = 1; factor <= 9; ++factor) {
      const double value = factor * std::pow(10.0, power);
      if (value < low_ * (1 - 1e-9) || value > high_ * (1 + 1e-9)) continue;
      const bool decade = factor == 1 && std::fmod(power, every) == 0;
      const bool fine = decades <= kFineDecades && (factor == 2 || factor == 5);
      if (decade || fine) {
        ticks_.push_back({value, number_text(value)});
      } else if (decades <= kMostTicks) {
        ticks_.push_back({value});
      }
    }
  }
}

void Scale::fit_categories(const Axis& axis) {
  logarithmic_ = false;
  low_ = -0.5;
  high_ = static_cast<double>(axis.categories.size()) - 0.5;
  for (std::size_t i = 0; i < axis.categories.size(); ++i) {
    ticks_.push_back({static_cast<double>(i), axis.categories[i]});
  }
}

}  // namespace tagmint::plot
