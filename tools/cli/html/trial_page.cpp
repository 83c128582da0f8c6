#include "cli/html/trial_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/html/chart.h"
#include "cli/html/markup.h"
#include "cli/html/page.h"
#include "cli/html/tag_svg.h"
#include "evaluate/family_trial.h"
#include "plot/draw_figure.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

using evaluate::Table;

std::vector<codec::SharedFamily> both(const codec::Family& family) {
  std::vector<codec::SharedFamily> families = {std::make_shared<const codec::Family>(family)};
  if (family.name() != evaluate::kYardstickFamily) {
    families.push_back(codec::find_family(evaluate::kYardstickFamily));
  }
  return families;
}

std::string hero(const std::vector<codec::SharedFamily>& families) {
  constexpr codec::TagId kShown = 3;
  std::string html = "<div class=\"hero\">\n";
  for (const codec::SharedFamily& family : families) {
    for (codec::TagId id = 0; id < std::min<std::size_t>(family->size(), kShown); ++id) {
      html += fmt::format("<figure>{}<figcaption>{}, id {}</figcaption></figure>\n",
                          tag_svg(*family, id), escaped(family->name()), id);
    }
  }
  return html + "</div>\n";
}

std::string facts(const std::vector<codec::SharedFamily>& families) {
  std::vector<std::vector<TableCell>> rows;
  for (const codec::SharedFamily& family : families) {
    rows.push_back(
        {{family->name(), true},
         {grouped(family->size())},
         {fmt::to_string(family->bits())},
         {fmt::to_string(family->min_hamming())},
         {fmt::to_string(family->max_safe_errors())},
         {codec::layout_name(family->layout()), true},
         {fmt::format("{} of {}", family->layout().width_at_border(), family->layout().width())}});
  }
  return html_table("The families",
                    {{"family", true},
                     {"tags"},
                     {"bits"},
                     {"distance"},
                     {"safe radius"},
                     {"layout", true},
                     {"border square, cells"}},
                    rows);
}

std::string share_text(const Table& table, const evaluate::Row& row) {
  const auto share = table.number(row, "share");
  return share ? fmt::format("{:.1f} %", 100 * *share) : "-";
}

/// A table of one measure: a row a level, a column for each family and contender.
std::string levels_table(const Table& table, const char* measure, const char* level_name) {
  std::vector<std::string> columns;
  std::vector<double> levels;
  for (const evaluate::Row& row : table.rows) {
    if (table.word(row, "measure") != measure) continue;
    const std::string column =
        fmt::format("{}, {}", table.word(row, "family"), table.word(row, "contender"));
    const double level = *table.number(row, "level");
    if (std::find(columns.begin(), columns.end(), column) == columns.end()) {
      columns.push_back(column);
    }
    if (std::find(levels.begin(), levels.end(), level) == levels.end()) levels.push_back(level);
  }
  std::vector<TableCell> header = {{level_name}};
  for (const std::string& column : columns) header.push_back({column});
  std::vector<std::vector<TableCell>> rows;
  for (const double level : levels) {
    std::vector<TableCell>& cells = rows.emplace_back();
    cells.push_back({fmt::format("{}", level)});
    for (const std::string& column : columns) {
      std::string text = "-";
      for (const evaluate::Row& row : table.rows) {
        if (table.word(row, "measure") == measure && table.number(row, "level") == level &&
            fmt::format("{}, {}", table.word(row, "family"), table.word(row, "contender")) ==
                column) {
          text = share_text(table, row);
        }
      }
      cells.push_back({std::move(text)});
    }
  }
  return html_table(level_name, header, rows);
}

/// Reports of tags that are not there, in pictures that have tags.
std::string mixed_up_text(const Table& table, const codec::SharedFamily& family) {
  double wrong = 0, found = 0;
  for (const evaluate::Row& row : table.rows) {
    if (table.word(row, "family") != family->name() || table.word(row, "contender") != "tagmint") {
      continue;
    }
    if (const auto count = table.number(row, "wrong")) {
      wrong += *count;
      found += *table.number(row, "hits");
    }
  }
  return fmt::format("{} beside {} right ones", wrong, found);
}

std::string mistaken(const Table& table, const std::vector<codec::SharedFamily>& families) {
  std::vector<std::vector<TableCell>> rows;
  LogChart chart{.id = "accepts",
                 .title = "Share of random words taken for a tag by corrected bits",
                 .across = "corrected bits",
                 .up = "share of random words",
                 .curves = {}};
  for (const codec::SharedFamily& family : families) {
    std::vector<TableCell> cells = {{family->name(), true}};
    for (const evaluate::Row& row : table.rows) {
      if (table.word(row, "family") != family->name()) continue;
      const std::string measure = table.word(row, "measure");
      if (measure == evaluate::kWords) {
        cells.push_back({fmt::format("{}", *table.number(row, "level"))});
        cells.push_back({fmt::format("{:.3g}", *table.number(row, "expected"))});
        cells.push_back(
            {fmt::format("{} of {}", *table.number(row, "hits"),
                         grouped(static_cast<std::uint64_t>(*table.number(row, "tried"))))});
      } else if (measure == evaluate::kClutter && table.word(row, "contender") == "tagmint") {
        cells.push_back({fmt::format("{} of {} quads", *table.number(row, "hits"),
                                     *table.number(row, "tried"))});
      }
    }
    cells.push_back({mixed_up_text(table, family)});
    rows.push_back(std::move(cells));
    ChartCurve curve{.label = family->name(), .values = {}, .solid = 2};
    for (int errors = 0; errors <= std::min(6, family->bits()); ++errors) {
      curve.values.push_back(codec::false_accept_rate(family->size(), family->bits(), errors));
    }
    curve.solid = family->max_safe_errors();
    chart.curves.push_back(std::move(curve));
  }
  return html_table("What is taken for a tag",
                    {{"family", true},
                     {"bits corrected"},
                     {"share of random words, theory"},
                     {"random words, measured"},
                     {"in clutter without tags"},
                     {"wrong reports above"}},
                    rows) +
         "<div class=\"charts\" style=\"max-width:34rem\"><figure><figcaption>Random words taken "
         "for a tag, theory; hollow: "
         "beyond the safe radius</figcaption>" +
         log_chart_svg(chart) + "</figure></div>\n";
}

/// The figure inside a page: without the XML declaration, as wide as there is room.
std::string inline_figure(const plot::Figure& figure) {
  std::string svg = plot::figure_svg(figure);
  svg.erase(0, svg.find("<svg"));
  const std::size_t end = svg.find('>');
  for (const char* side : {" width=\"", " height=\""}) {
    const std::size_t at = svg.find(side);
    if (at == std::string::npos || at > end) continue;
    svg.erase(at, svg.find('"', at + std::string_view(side).size()) + 1 - at);
  }
  return svg;
}

}  // namespace

std::string trial_page(const codec::Family& family, const evaluate::Outcome& outcome,
                       const std::vector<std::string>& conditions, const std::string& command) {
  const auto families = both(family);
  const Table& table = outcome.table;
  std::string page = page_head(family.name() + " - how it is found");
  page += fmt::format(
      "<body>\n<header>\n<h1>{}</h1>\n<p class=\"lead\">How its tags are found by size, angle and "
      "noise, and how often something else is taken for one, beside {}</p>\n"
      "<nav class=\"contents\" aria-label=\"Contents\"><a href=\"#families\">Families</a>"
      "<a href=\"#found\">Found</a><a href=\"#mistaken\">Mistaken</a><a href=\"#tables\">Tables</a>"
      "<a href=\"#how\">How it was measured</a></nav>\n</header>\n<main>\n",
      escaped(family.name()), evaluate::kYardstickFamily);
  page += "<section id=\"families\">\n" + hero(families) + facts(families) + "</section>\n";
  page += "<section id=\"found\">\n<h2>Found</h2>\n<figure style=\"margin:0;background:#fff\">" +
          inline_figure(outcome.figure) + "</figure>\n</section>\n";
  page +=
      "<section id=\"mistaken\">\n<h2>Mistaken</h2>\n" + mistaken(table, families) + "</section>\n";
  page += "<section id=\"tables\">\n<h2>Share of tags found</h2>\n" +
          levels_table(table, evaluate::kBySize, "side of the whole tag, px") +
          levels_table(table, evaluate::kByAngle, "off-axis angle, degrees") +
          levels_table(table, evaluate::kByNoise, "noise, gray levels") + "</section>\n";
  page += "<section id=\"how\">\n<h2>How it was measured</h2>\n<ul>\n";
  for (const std::string& line : conditions) page += fmt::format("<li>{}</li>\n", escaped(line));
  return page + fmt::format("</ul>\n<pre>{}</pre>\n</section>\n", escaped(command)) + page_foot();
}

}  // namespace tagmint::cli
