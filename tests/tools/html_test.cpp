// Parts of a family's page: text that is safe in HTML, tags as paths, charts.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "cli/html/chart.h"
#include "cli/html/markup.h"
#include "cli/html/tag_svg.h"
#include "cli/shell_word.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::cli {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Markup, EscapesWhatHtmlWouldRead) {
  EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
  const std::string table = html_table("t", {{"<"}}, {{{"&", true}}});
  EXPECT_NE(table.find("<th scope=\"col\">&lt;</th>"), std::string::npos) << table;
  EXPECT_NE(table.find("<td class=\"text\">&amp;</td>"), std::string::npos) << table;
}

TEST(Markup, GroupsDigits) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(4193280), "4,193,280");
}

TEST(ShellWord, QuotesWhatAShellWouldRead) {
  EXPECT_EQ(shell_word("out/tag36h11.json"), "out/tag36h11.json");
  EXPECT_EQ(shell_word("my tags.json"), "'my tags.json'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
}

/// The cells inside of a path, by the even-odd rule: how many of its vertical lines lie to the left
/// of the middle of each cell.
std::vector<std::string> filled_rows(const std::string& path, int width) {
  std::vector<std::string> rows(static_cast<std::size_t>(width),
                                std::string(static_cast<std::size_t>(width), '.'));
  static const std::regex part("M(\\d+) (\\d+)|H(\\d+)|V(\\d+)|z");
  int x = 0;
  int y = 0;
  int start_y = 0;
  const auto cross = [&](int to) {
    for (int row = std::min(y, to); row < std::max(y, to); ++row) {
      for (int column = x; column < width; ++column) {
        char& cell = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
        cell = cell == '.' ? '#' : '.';
      }
    }
    y = to;
  };
  for (std::sregex_iterator at(path.begin(), path.end(), part), end; at != end; ++at) {
    const std::smatch& match = *at;
    if (match[1].matched) {
      x = std::stoi(match[1]);
      y = start_y = std::stoi(match[2]);
    } else if (match[3].matched) {
      x = std::stoi(match[3]);
    } else if (match[4].matched) {
      cross(std::stoi(match[4]));
    } else {
      cross(start_y);
    }
  }
  return rows;
}

TEST(TagSvg, PathFillsTheBlackCells) {
  for (const char* name : {"tag16h5", "tagCircle21h7", "tagCustom48h12", "rot64"}) {
    const codec::SharedFamily family = codec::find_family(name);
    for (codec::TagId id = 0; id < 30; ++id) {
      const codec::TagCells cells = codec::tag_cells(family->layout(), family->codeword(id));
      std::vector<std::string> expected = cells.rows();
      for (std::string& row : expected) {
        for (char& cell : row) cell = cell == 'b' ? '#' : '.';
      }
      EXPECT_EQ(filled_rows(black_path(cells), cells.width()), expected) << name << " " << id;
    }
  }
}

TEST(TagSvg, PlacesWithoutACellAreTold) {
  EXPECT_EQ(blank_path(codec::find_family("tag36h11")->layout()), "");
  EXPECT_EQ(blank_path(codec::find_family("tagCustom48h12")->layout()), "M4 4H6V6H4z");
}

TEST(BarChart, OfAlikeCountsIsLinearAndNamesItsAxes) {
  const std::string svg = bar_chart_svg({.id = "c",
                                         .title = "some <title>",
                                         .across = "bits",
                                         .up = "pairs",
                                         .bars = {{3, 10, "three"}, {5, 40, "five"}},
                                         .mark = ChartMark{4, "4 declared"}});
  EXPECT_EQ(count_of(svg, "<rect class=\"bar\""), 2U);
  EXPECT_NE(svg.find("aria-label=\"some &lt;title&gt;\""), std::string::npos) << svg;
  for (const char* part : {">bits</text>", ">pairs</text>", ">4 declared</text>", "<title>five",
                           ">3</text>", ">4</text>", ">5</text>", ">40</text>"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part << "\n" << svg;
  }
  EXPECT_EQ(svg.find("logarithmic"), std::string::npos);
}

TEST(BarChart, OfVeryDifferentCountsIsLogarithmicAndSaysSo) {
  const std::string svg = bar_chart_svg({.id = "c",
                                         .title = "t",
                                         .across = "bits",
                                         .up = "pairs",
                                         .bars = {{3, 1, "one"}, {4, 1e6, "many"}},
                                         .mark = {}});
  EXPECT_NE(svg.find(">pairs (logarithmic)</text>"), std::string::npos);
  EXPECT_NE(svg.find(">1e6</text>"), std::string::npos) << svg;
  // A count of 1 has some height too.
  std::smatch match;
  ASSERT_TRUE(std::regex_search(svg, match, std::regex("height=\"([0-9.]+)\"><title>one")));
  EXPECT_GT(std::stod(match[1]), 5);
}

TEST(BarChart, WithoutBarsIsEmpty) { EXPECT_EQ(bar_chart_svg(BarChart{}), ""); }

TEST(LogChart, OfSeveralCurvesHasALegendAndHollowPoints) {
  const std::string svg =
      log_chart_svg({.id = "c",
                     .title = "t",
                     .across = "corrected bits",
                     .up = "share",
                     .curves = {{"first", {1e-9, 1e-6, 1e-3}, 1}, {"second", {1e-8, 1e-5}, 1}}});
  EXPECT_EQ(count_of(svg, " hollow\""), 1U);
  EXPECT_NE(svg.find(">first</text>"), std::string::npos);
  EXPECT_NE(svg.find(">second</text>"), std::string::npos);
  EXPECT_NE(svg.find(">1e-9</text>"), std::string::npos) << svg;
}

}  // namespace
}  // namespace tagmint::cli
