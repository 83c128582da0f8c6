#include "cli/html/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/html/markup.h"

namespace tagmint::cli {
namespace {

// The picture's own units; a style sheet gives its width.
constexpr double kWidth = 480;
constexpr double kHeight = 300;
constexpr double kLeft = 64;
constexpr double kRight = 470;
constexpr double kTop = 38;
constexpr double kBottom = 252;
constexpr double kLegendLine = 18;
/// Counts that differ more than this are shown by their logarithm.
constexpr double kLinearRange = 200;
constexpr double kMostLabels = 13;

/// The vertical axis: from value to height, and where its lines are.
struct Scale {
  bool logarithmic = false;
  double low = 0;
  double high = 1;
  std::vector<double> lines;

  double height(double value) const {
    const double share =
        logarithmic ? (std::log10(value) - low) / (high - low) : (value - low) / (high - low);
    return kBottom - std::clamp(share, 0.0, 1.0) * (kBottom - kTop);
  }
};

/// 1, 2 or 5 times a power of ten, so that about `parts` of them make `range`.
double round_step(double range, double parts) {
  const double raw = range / parts;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10 * power;
}

Scale linear_scale(double largest) {
  // Counts are whole: no lines between them.
  const double step = std::max(1.0, round_step(largest, 5));
  Scale scale{.low = 0, .high = std::ceil(largest / step) * step, .lines = {}};
  for (double line = 0; line <= scale.high; line += step) scale.lines.push_back(line);
  return scale;
}

/// `below`: how many decades further down the axis begins, so that the least value shows.
Scale log_scale(double smallest, double largest, double below) {
  Scale scale{.logarithmic = true,
              .low = std::floor(std::log10(smallest)) - below,
              .high = std::ceil(std::log10(largest) - 1e-9),
              .lines = {}};
  if (scale.high <= scale.low) scale.high = scale.low + 1;
  const double step = std::max(1.0, std::ceil((scale.high - scale.low) / 7));
  for (double power = scale.high; power >= scale.low; power -= step) {
    scale.lines.push_back(std::pow(10.0, power));
  }
  return scale;
}

std::string number_text(double value) {
  if (value >= 1e6 || (value > 0 && value < 1e-3)) {
    const double power = std::floor(std::log10(value) + 1e-9);
    const double factor = value / std::pow(10.0, power);
    return std::abs(factor - 1) < 1e-6 ? fmt::format("1e{:.0f}", power)
                                       : fmt::format("{:.3g}e{:.0f}", factor, power);
  }
  return value >= 1000 ? grouped(static_cast<std::uint64_t>(value)) : fmt::format("{:.4g}", value);
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor,
                     escaped(text));
}

std::string line(double x0, double y0, double x1, double y1, std::string_view kind) {
  return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"></path>", kind, x0, y0,
                     x1, y1);
}

std::string begin(std::string_view id, std::string_view title, double height) {
  return fmt::format(
      "<svg class=\"chart\" id=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" "
      "aria-label=\"{}\">",
      id, kWidth, height, escaped(title));
}

/// Lines and numbers of the vertical axis, and what both axes mean.
std::string frame(const Scale& scale, std::string_view across, std::string_view up) {
  std::string svg;
  for (const double value : scale.lines) {
    const double y = scale.height(value);
    svg += line(kLeft, y, kRight, y, "rule") + text_at(kLeft - 6, y + 4, "end", number_text(value));
  }
  svg += line(kLeft, kBottom, kRight, kBottom, "axis") + line(kLeft, kTop, kLeft, kBottom, "axis");
  svg +=
      text_at(4, 13, "start", fmt::format("{}{}", up, scale.logarithmic ? " (logarithmic)" : ""));
  return svg + text_at((kLeft + kRight) / 2, kBottom + 36, "middle", across);
}

/// A point of a curve, each curve with a form of its own.
std::string point(double x, double y, std::size_t form, bool solid) {
  constexpr std::array<const char*, 5> kForms = {
      "m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z", "m-3.5-3.5h7v7h-7z", "m0-5l4.5 8h-9z",
      "m0-5.5l5.5 5.5l-5.5 5.5l-5.5-5.5z", "m0 5l4.5-8h-9z"};
  return fmt::format("<path class=\"point s{}{}\" d=\"M{:.1f} {:.1f}{}\"></path>", form,
                     solid ? "" : " hollow", x, y, kForms[form]);
}

}  // namespace

std::string bar_chart_svg(const BarChart& chart) {
  if (chart.bars.empty()) return {};
  const auto [smallest, largest] =
      std::minmax_element(chart.bars.begin(), chart.bars.end(),
                          [](const ChartBar& a, const ChartBar& b) { return a.count < b.count; });
  const Scale scale = largest->count > kLinearRange * smallest->count
                          ? log_scale(smallest->count, largest->count, 0.5)
                          : linear_scale(largest->count);
  double first = chart.bars.front().at;
  double last = chart.bars.back().at;
  if (chart.mark) {
    first = std::min(first, chart.mark->at);
    last = std::max(last, chart.mark->at);
  }
  first -= chart.step;
  last += chart.step + chart.shift;
  const auto across = [&](double at) {
    return kLeft + (at - first) / (last - first) * (kRight - kLeft);
  };
  std::string svg = begin(chart.id, chart.title, kHeight) + frame(scale, chart.across, chart.up);
  const double width = (across(chart.step) - across(0)) * 0.78;
  for (const ChartBar& bar : chart.bars) {
    const double top = scale.height(bar.count);
    svg += fmt::format(
        "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">"
        "<title>{}</title></rect>",
        across(bar.at + chart.shift) - width / 2, top, width, std::max(kBottom - top, 0.5),
        escaped(bar.title));
  }
  const double slots = std::round((last - first) / chart.step);
  const double every = std::max(1.0, round_step(slots, kMostLabels)) * chart.step;
  // From a multiple of the step, so that labels are round.
  for (double at = std::ceil((first + chart.step) / every - 1e-9) * every;
       at <= last - chart.step + chart.shift + 1e-9; at += every) {
    svg += line(across(at), kBottom, across(at), kBottom + 4, "axis") +
           text_at(across(at), kBottom + 18, "middle", fmt::format("{:.4g}", at));
  }
  if (chart.mark) {
    const double x = across(chart.mark->at);
    svg += line(x, kTop, x, kBottom, "mark");
    const bool right = x < (kLeft + kRight) / 2;
    svg += text_at(right ? x + 5 : x - 5, kTop - 6, right ? "start" : "end", chart.mark->label);
  }
  return svg + "</svg>\n";
}

std::string log_chart_svg(const LogChart& chart) {
  double smallest = chart.curves.front().values.front();
  double largest = smallest;
  std::size_t places = 2;
  for (const ChartCurve& curve : chart.curves) {
    for (const double value : curve.values) {
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
    places = std::max(places, curve.values.size());
  }
  const Scale scale = log_scale(smallest, largest, 0);
  const double step = (kRight - kLeft - 24) / static_cast<double>(places - 1);
  const auto across = [&](std::size_t at) { return kLeft + 12 + step * static_cast<double>(at); };
  const bool legend = chart.curves.size() > 1;
  const double height =
      kHeight + (legend ? kLegendLine * static_cast<double>(chart.curves.size()) : 0);
  std::string svg = begin(chart.id, chart.title, height) + frame(scale, chart.across, chart.up);
  const std::size_t every = places > 16 ? 2 : 1;
  for (std::size_t at = 0; at < places; at += every) {
    svg += line(across(at), kBottom, across(at), kBottom + 4, "axis") +
           text_at(across(at), kBottom + 18, "middle", fmt::to_string(at));
  }
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const ChartCurve& curve = chart.curves[i];
    std::string path;
    std::string points;
    for (std::size_t at = 0; at < curve.values.size(); ++at) {
      const double y = scale.height(curve.values[at]);
      path += fmt::format("{}{:.1f} {:.1f}", at == 0 ? 'M' : 'L', across(at), y);
      points += point(across(at), y, i, static_cast<int>(at) <= curve.solid);
    }
    svg += fmt::format("<path class=\"curve s{}\" d=\"{}\"></path>", i, path) + points;
    if (!legend) continue;
    const double y = kHeight + kLegendLine * (static_cast<double>(i) + 0.3);
    svg += fmt::format("<path class=\"curve s{}\" d=\"M{:.1f} {:.1f}h36\"></path>", i, kLeft, y) +
           point(kLeft + 18, y, i, true) + text_at(kLeft + 46, y + 4, "start", curve.label);
  }
  return svg + "</svg>\n";
}

}  // namespace tagmint::cli
