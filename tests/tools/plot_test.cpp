// Figures: axes, legends, and what the files hold.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "io/images.h"
#include "plot/draw_figure.h"
#include "plot/legend.h"
#include "plot/scale.h"
#include "plot/style.h"

namespace tagmint::plot {
namespace {

Figure sample() {
  Panel panel{.title = "left",
              .x = {.label = "distance, m", .low = 0},
              .y = {.label = "error, m", .logarithmic = true},
              .series = {{.label = "ours <new>", .style = 0, .spots = {{1, 0.001}, {10, 0.1}}},
                         {.label = "theirs", .style = 1, .spots = {{1, 0.002}, {10, 0.5}}}}};
  Panel other = panel;
  other.title = "right";
  other.series.pop_back();
  return {.title = "Error & distance", .panels = {panel, other}};
}

std::vector<std::string> texts(const Scale& scale) {
  std::vector<std::string> all;
  for (const Tick& tick : scale.ticks()) {
    if (!tick.text.empty()) all.push_back(tick.text);
  }
  return all;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(PlotScale, LinearAxisHasRoundTicksAroundAllValues) {
  const Scale scale({.label = ""}, {0.3, 9.2});
  EXPECT_EQ(texts(scale), (std::vector<std::string>{"0", "2", "4", "6", "8", "10"}));
  EXPECT_DOUBLE_EQ(scale.share(0), 0);
  EXPECT_DOUBLE_EQ(scale.share(5), 0.5);
  EXPECT_DOUBLE_EQ(scale.share(10), 1);
}

TEST(PlotScale, LogarithmicAxisIsEvenByFactors) {
  const Scale scale({.label = "", .logarithmic = true}, {0.001, 0.1});
  EXPECT_NEAR(scale.share(0.01), 0.5, 1e-12);
  EXPECT_EQ(texts(scale),
            (std::vector<std::string>{"0.001", "0.002", "0.005", "0.01", "0.02", "0.05", "0.1"}));
  EXPECT_FALSE(scale.can_show(0));
  EXPECT_FALSE(scale.can_show(-1));
  EXPECT_FALSE(scale.can_show(NAN));
}

TEST(PlotScale, NoValuesOrOneValueMakeAnAxisToo) {
  for (const bool logarithmic : {false, true}) {
    for (const std::vector<double>& values : {std::vector<double>{}, {3.0}}) {
      const Scale scale({.label = "", .logarithmic = logarithmic}, values);
      EXPECT_LT(scale.low(), scale.high());
      EXPECT_GE(texts(scale).size(), 2U);
    }
  }
}

TEST(PlotLegend, NamesEachSeriesOnce) {
  const auto entries = legend_of(sample());
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].label, "ours <new>");
  EXPECT_EQ(entries[1].label, "theirs");
}

TEST(PlotFigure, SvgSaysInWordsWhatItShows) {
  const std::string svg = figure_svg(sample());
  EXPECT_NE(svg.find("<title>Error &amp; distance</title>"), std::string::npos);
  EXPECT_NE(svg.find("<desc>left: error, m against distance, m: ours &lt;new&gt;; theirs. "
                     "right: error, m against distance, m: ours &lt;new&gt;.</desc>"),
            std::string::npos);
}

TEST(PlotFigure, SvgHasLinesInTwoDashesAndText) {
  const std::string svg = figure_svg(sample());
  EXPECT_EQ(count(svg, "stroke-dasharray:8,3"), 2U);  // the second style: its curve and the legend
  // Letters of title, axes, ticks and legend.
  EXPECT_GT(count(svg, "<use "), 100U);
  Figure bare = sample();
  for (Panel& panel : bare.panels) {
    for (Series& series : panel.series) series.label.clear();
  }
  EXPECT_LT(count(figure_svg(bare), "<use "), count(svg, "<use ") - 10);
}

TEST(PlotFigure, SameFigureGivesTheSameBytes) {
  const std::string svg = figure_svg(sample());
  figure_png(sample());
  EXPECT_EQ(figure_svg(sample()), svg);
  EXPECT_EQ(figure_png(sample()), figure_png(sample()));
}

TEST(PlotFigure, PngIsWhiteWithInk) {
  const detect::Image image = io::decode_gray_image(figure_png(sample(), 1), "figure");
  EXPECT_EQ(image.width(), 820);
  EXPECT_EQ(image.at(1, 1), 255);
  int dark = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) dark += image.at(x, y) < 100;
  }
  EXPECT_GT(dark, 1000);
}

TEST(PlotStyle, StylesDifferWithoutColour) {
  for (int a = 0; a < kStyles; ++a) {
    for (int b = 0; b < a; ++b) EXPECT_NE(style_of(a).marker, style_of(b).marker);
  }
  EXPECT_THROW(style_of(kStyles), std::invalid_argument);
  EXPECT_THROW(figure_svg(Figure{}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::plot
