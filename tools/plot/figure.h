#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tagmint::plot {

/// One axis of a panel. The label carries the unit: "distance, m".
struct Axis {
  std::string label;
  bool logarithmic = false;         ///< values must be above 0; others are left out
  std::optional<double> low = {};   ///< where it begins; nothing = below the smallest value
  std::optional<double> high = {};  ///< where it ends; nothing = above the largest value
  /// Names in place of numbers: value i is categories[i].
  std::vector<std::string> categories = {};
};

/// A place of a panel.
struct Spot {
  double x = 0;
  double y = 0;
  /// No value but a bound: nothing was counted, so the true value is probably below. Drawn hollow
  /// with an arrow.
  bool bound = false;
  std::string text = {};  ///< beside the marker, may be empty
};

/// Spots that belong together. Series of the same label in several panels look alike and share one
/// entry of the legend.
struct Series {
  std::string label;
  int style = 0;  ///< colour, dashes and marker: 0 .. kStyles - 1
  std::vector<Spot> spots;
  bool line = true;
  bool markers = true;
};

/// A value with a meaning, as a thin line across the panel.
struct Mark {
  double at = 0;
  bool across = true;  ///< at a value of y, from left to right; false = of x
  std::string text;
};

/// One pair of axes and what is drawn in it.
struct Panel {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
  std::vector<Mark> marks = {};
};

/// Panels in rows of `columns`, a title above, a legend and a note below.
struct Figure {
  std::string title;
  std::vector<Panel> panels;
  int columns = 2;
  std::string note = {};  ///< one line of small print, may be empty
};

}  // namespace tagmint::plot
