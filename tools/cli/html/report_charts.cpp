#include "cli/html/report_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/html/chart.h"
#include "cli/html/markup.h"

namespace tagmint::cli {
namespace {

/// Averages and counts: whole ones are written whole.
std::string count_text(double count) {
  return count == std::floor(count) && count < 1e15 ? grouped(static_cast<std::uint64_t>(count))
                                                    : fmt::format("{:.6g}", count);
}

std::string figure(std::string_view caption, std::string_view note, std::string_view svg,
                   std::string_view table) {
  return fmt::format(
      "<figure>\n<figcaption>{}</figcaption>\n{}{}<details><summary>The "
      "numbers</summary>\n{}</details>\n</figure>\n",
      escaped(caption), svg, note.empty() ? "" : fmt::format("<p>{}</p>\n", escaped(note)), table);
}

/// A histogram as a figure; nothing where there is nothing to count.
///   what   of a bar, "pairs"
std::string histogram(const std::string& caption, const std::string& note, BarChart chart,
                      const std::string& what) {
  if (chart.bars.empty()) return {};
  chart.title = fmt::format("{}: {} bars from {:.4g} to {:.4g}", caption, chart.bars.size(),
                            chart.bars.front().at, chart.bars.back().at);
  std::vector<std::vector<TableCell>> rows;
  for (ChartBar& bar : chart.bars) {
    bar.title = fmt::format("{:.4g}: {} {}", bar.at, count_text(bar.count), what);
    rows.push_back({{fmt::format("{:.4g}", bar.at)}, {count_text(bar.count)}});
  }
  return figure(caption, note, bar_chart_svg(chart),
                html_table(caption, {{chart.across}, {chart.up}}, rows));
}

template <typename Count>
std::vector<ChartBar> bars_of(const std::vector<Count>& counts, std::size_t first = 0) {
  std::vector<ChartBar> bars;
  for (std::size_t at = first; at < counts.size(); ++at) {
    if (counts[at] > 0) {
      bars.push_back({static_cast<double>(at), static_cast<double>(counts[at]), {}});
    }
  }
  return bars;
}

std::string distances(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  const ChartMark declared{static_cast<double>(family.min_hamming()),
                           fmt::format("{} declared", family.min_hamming())};
  if (family.is_listed()) {
    return histogram("Distances between tags",
                     "The least of the four rotations, for every pair of tags.",
                     {.id = "distances",
                      .title = {},
                      .across = "Hamming distance in bits",
                      .up = "pairs of tags",
                      .bars = bars_of(report.stats.distance_histogram),
                      .mark = declared},
                     "pairs");
  }
  const bool average = family.generator()->cosets().size() > 1;
  return histogram("Distances between words of the code",
                   fmt::format("From one word to all others{}; each turn of a tag is a word.",
                               average ? ", on average" : ""),
                   // The word itself, at distance 0, is left out.
                   {.id = "distances",
                    .title = {},
                    .across = "Hamming distance in bits",
                    .up = "words",
                    .bars = bars_of(report.stats.word_distances, 1),
                    .mark = declared},
                   "words");
}

std::string self_distances(const FamilyReport& report) {
  return histogram(
      "Distances to the own turns",
      "The least number of cells that change when a tag is turned by 90, 180 or 270 degrees.",
      {.id = "turns",
       .title = {},
       .across = "Hamming distance in bits",
       .up = "tags",
       .bars = bars_of(report.stats.self_histogram),
       .mark = ChartMark{static_cast<double>(report.family->min_hamming()),
                         fmt::format("{} declared", report.family->min_hamming())}},
      "tags");
}

std::string complexity(const FamilyReport& report) {
  const codec::Complexity& rule = report.family->complexity();
  const bool rectangles = report.complexity_measure == "rectangles";
  BarChart chart{
      .id = "complexity",
      .title = {},
      .across = rectangles ? "rectangles needed to paint the tag" : "colour changes / (2 cells)",
      .up = "tags",
      .step = rectangles ? 1 : kEnergyStep,
      .shift = rectangles ? 0 : kEnergyStep / 2,
      .bars = {},
      .mark = {}};
  for (const auto& [value, tags] : report.complexity_histogram) {
    chart.bars.push_back({value, static_cast<double>(tags), {}});
  }
  if (rule.rule != codec::ComplexityRule::None) {
    chart.mark = ChartMark{rule.threshold, fmt::format("at least {:.4g}", rule.threshold)};
  }
  return histogram("Complexity",
                   "Plain patterns are imitated by texture more often than busy ones.",
                   std::move(chart), "tags");
}

/// Corrected bits shown: two above the safe radius, where wrong ids begin.
int most_errors(int safe, int bits) { return std::min(bits / 2, std::max(safe + 2, 3)); }

ChartCurve curve_of(const std::string& label, std::size_t codes, int bits, int distance) {
  ChartCurve curve{.label = label, .values = {}, .solid = std::max(0, (distance - 1) / 2)};
  for (int errors = 0; errors <= most_errors(curve.solid, bits); ++errors) {
    curve.values.push_back(codec::false_accept_rate(codes, bits, errors));
    if (curve.values.back() >= 1) break;
  }
  return curve;
}

std::string false_accepts(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  LogChart chart{.id = "accepts",
                 .title = "Share of random words taken for a tag, by corrected bits",
                 .across = "corrected bits",
                 .up = "share of random words",
                 .curves = {}};
  std::vector<TableCell> header = {{"corrected bits"}};
  std::size_t longest = 0;
  for (std::size_t i = 0; i < family.levels().size(); ++i) {
    const codec::Level& level = family.levels()[i];
    const std::string label =
        family.levels().size() == 1
            ? "all tags"
            : fmt::format("ids 0-{}, distance {}", level.codes - 1, level.min_hamming);
    chart.curves.push_back(
        curve_of(label, level.codes, family.bits(),
                 std::min(level.min_hamming, report.stats.levels[i].min_hamming)));
    header.push_back({label});
    longest = std::max(longest, chart.curves.back().values.size());
  }
  std::vector<std::vector<TableCell>> rows;
  for (std::size_t errors = 0; errors < longest; ++errors) {
    rows.push_back({{fmt::to_string(errors)}});
    for (const ChartCurve& curve : chart.curves) {
      rows.back().push_back({errors < curve.values.size()
                                 ? fmt::format("{:.3g}{}", curve.values[errors],
                                               static_cast<int>(errors) > curve.solid ? " *" : "")
                                 : std::string("-")});
    }
  }
  return figure("False accepts",
                "Hollow points, and * in the table: above the safe radius, where errors may also "
                "turn one tag into another. All four rotations are counted.",
                log_chart_svg(chart), html_table("False accepts", header, rows));
}

}  // namespace

std::string report_charts_html(const FamilyReport& report) {
  return "<div class=\"charts\">\n" + distances(report) + self_distances(report) +
         complexity(report) + false_accepts(report) + "</div>\n";
}

}  // namespace tagmint::cli
