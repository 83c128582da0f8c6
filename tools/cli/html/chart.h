#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tagmint::cli {

/// A count at a place of the horizontal axis.
struct ChartBar {
  double at = 0;
  double count = 0;   ///< above 0
  std::string title;  ///< what a pointer over the bar shows
};

/// A place of the horizontal axis that has a meaning.
struct ChartMark {
  double at = 0;
  std::string label;
};

/// How often what occurs.
struct BarChart {
  std::string id;              ///< of the element, for labels
  std::string title;           ///< for those who do not see it
  std::string across;          ///< the horizontal axis with its unit, "Hamming distance in bits"
  std::string up;              ///< the vertical axis, "pairs of tags"
  double step = 1;             ///< between bars that may be, above 0
  double shift = 0;            ///< middle of a bar less its place: step / 2 where bars begin there
  std::vector<ChartBar> bars;  ///< in ascending order
  std::optional<ChartMark> mark;
};

/// The chart as an SVG element of class "chart", whose colours a style sheet gives. The vertical
/// axis is logarithmic, and says so, where the largest count is more than 200 times the smallest.
/// Empty for a chart without bars.
std::string bar_chart_svg(const BarChart& chart);

/// Figures of one thing, the first one at 0 of the horizontal axis, the next at 1, ...
struct ChartCurve {
  std::string label;
  std::vector<double> values;  ///< above 0
  int solid = 0;               ///< points up to here are filled, those after it hollow
};

/// Values over many orders of magnitude.
struct LogChart {
  std::string id;
  std::string title;
  std::string across;
  std::string up;
  std::vector<ChartCurve> curves;  ///< 1 to 5
};

/// The chart as an SVG element, the vertical axis logarithmic. Curves differ by colour, dashes and
/// the form of their points; a legend names them where there are several.
std::string log_chart_svg(const LogChart& chart);

}  // namespace tagmint::cli
