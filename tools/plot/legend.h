#pragma once

#include <string>
#include <vector>

#include "plot/figure.h"
#include "plot/pen.h"

namespace tagmint::plot {

/// The series of all panels, each label once, in the order in which they first occur. A series
/// without a label has no entry.
struct LegendEntry {
  std::string label;
  int style = 0;
  bool line = true;
  bool markers = true;
};
std::vector<LegendEntry> legend_of(const Figure& figure);

/// Rows that the entries take in that width.
int legend_rows(Pen& pen, const std::vector<LegendEntry>& entries, double width_px);
inline constexpr double kLegendRow_px = 18;

/// Draws the entries row by row from the box's top.
void draw_legend(Pen& pen, const std::vector<LegendEntry>& entries, const Box& box);

}  // namespace tagmint::plot
