#include "plot/legend.h"

#include <algorithm>

namespace tagmint::plot {
namespace {

constexpr double kText_px = 11.5;
constexpr double kSample_px = 34;
constexpr double kGap_px = 22;

/// Calls put(entry, x, row) for each entry where it goes.
template <typename Put>
int lay_out(Pen& pen, const std::vector<LegendEntry>& entries, double width_px, Put put) {
  double x = 0;
  int row = 0;
  for (const LegendEntry& entry : entries) {
    const double width = kSample_px + 6 + pen.text_width(entry.label, kText_px);
    if (x > 0 && x + width > width_px) {
      x = 0;
      ++row;
    }
    put(entry, x, row);
    x += width + kGap_px;
  }
  return entries.empty() ? 0 : row + 1;
}

}  // namespace

std::vector<LegendEntry> legend_of(const Figure& figure) {
  std::vector<LegendEntry> entries;
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      const bool known = std::any_of(entries.begin(), entries.end(), [&](const LegendEntry& entry) {
        return entry.label == series.label;
      });
      if (!known && !series.label.empty()) {
        entries.push_back({series.label, series.style, series.line, series.markers});
      }
    }
  }
  return entries;
}

int legend_rows(Pen& pen, const std::vector<LegendEntry>& entries, double width_px) {
  return lay_out(pen, entries, width_px, [](const LegendEntry&, double, int) {});
}

void draw_legend(Pen& pen, const std::vector<LegendEntry>& entries, const Box& box) {
  lay_out(pen, entries, box.width, [&](const LegendEntry& entry, double x, int row) {
    const double left = box.left + x;
    const double y = box.top + kLegendRow_px * (row + 0.5);
    const Style& style = style_of(entry.style);
    if (entry.line) {
      cairo_new_path(pen.context());
      cairo_move_to(pen.context(), left, y);
      cairo_line_to(pen.context(), left + kSample_px, y);
      pen.stroke(style);
    }
    if (entry.markers) pen.marker(style, left + kSample_px / 2, y, false);
    pen.text(left + kSample_px + 6, y + 4, entry.label, kText_px, Align::Left);
  });
}

}  // namespace tagmint::plot
