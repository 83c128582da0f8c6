#include "cli/html/family_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/choose_report.h"
#include "cli/html/gallery.h"
#include "cli/html/markup.h"
#include "cli/html/page.h"
#include "cli/html/report_charts.h"
#include "cli/html/tag_svg.h"
#include "cli/shell_word.h"
#include "draw/units.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

/// Rows of the facts: name and text.
using Facts = std::vector<std::pair<std::string, std::string>>;

std::string facts_html(const Facts& facts) {
  std::string html = "<div class=\"scroll\"><table class=\"facts\">\n<tbody>\n";
  for (const auto& [name, text] : facts) {
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", escaped(name),
                        escaped(text));
  }
  return html + "</tbody>\n</table></div>\n";
}

std::string bits_text(int bits) { return fmt::format("{} bit{}", bits, bits == 1 ? "" : "s"); }

std::string lead(const codec::Family& family) {
  return fmt::format(
      "<p class=\"lead\">{} tags of {}, at least {} apart however they are turned"
      "</p>\n",
      grouped(family.size()), bits_text(family.bits()), bits_text(family.min_hamming()));
}

/// What the codes do not keep of the family's word.
std::string warnings(const FamilyReport& report) {
  std::string html;
  const int declared = report.family->min_hamming();
  const int found = report.stats.min_hamming;
  if (found == 0) {
    html +=
        "<p class=\"warning\">Some tag is equal to a turn of itself or of another: even without an "
        "error its id or its corners are ambiguous.</p>\n";
  } else if (found < declared) {
    html += fmt::format(
        "<p class=\"warning\">The family declares a distance of {}, but its codes are only {} "
        "apart.</p>\n",
        declared, bits_text(found));
  }
  return html;
}

std::string safe_radius_html(const FamilyReport& report) {
  const auto safe = report.safe_errors();
  if (!safe) return {};
  const int distance = std::min(report.family->min_hamming(), report.stats.min_hamming);
  const double rate = codec::false_accept_rate(report.family->size(), report.family->bits(), *safe);
  const std::string accepts =
      fmt::format("With {} corrected, {} random words passes for a tag", *safe, one_in_text(rate));
  return fmt::format(
      "<p><strong>Safe radius: {}.</strong> Up to {} misread cells of a tag are always corrected "
      "to "
      "the right id and the right turn, because {} cells or more differ between any two tags and "
      "any two turns: ({} - 1) / 2, rounded down. {}; decoders correct 2 unless told otherwise.</p>"
      "\n",
      *safe, *safe, distance, distance, accepts);
}

std::string hero(const codec::Family& family) {
  std::string html = "<div class=\"hero\">\n";
  const std::size_t shown = std::min<std::size_t>(family.size(), 6);
  for (codec::TagId id = 0; id < shown; ++id) {
    html +=
        fmt::format("<figure>{}<figcaption>id {}</figcaption></figure>\n", tag_svg(family, id), id);
  }
  return html + "</div>\n";
}

std::string summary(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  const codec::Layout& layout = family.layout();
  return facts_html(
      {{"tags", fmt::format("{}, ids 0 to {}", grouped(family.size()), family.size() - 1)},
       {"bits", fmt::to_string(family.bits())},
       {"distance declared", fmt::to_string(family.min_hamming())},
       {"distance found", fmt::to_string(report.stats.min_hamming)},
       {"nearest tags", nearest_text(report)},
       {"to the own turns", fmt::format("at least {}", bits_text(report.self_distance))},
       {"layout", codec::layout_name(layout)},
       {"border square",
        fmt::format("{} of {} cells, {}", layout.width_at_border(), layout.width(),
                    layout.reversed_border() ? "white inside black" : "black inside white")},
       {"complexity", complexity_text(report)},
       {"origin", origin_text(family.origin())},
       {"codewords' SHA-256", report.digest}});
}

/// A row for each level; nothing where the family is one.
std::string levels(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  if (family.levels().size() == 1) return {};
  std::vector<std::vector<TableCell>> rows;
  for (std::size_t i = 0; i < family.levels().size(); ++i) {
    const codec::Level& level = family.levels()[i];
    const int safe = (level.min_hamming - 1) / 2;
    const auto rate = [&](int errors) {
      return fmt::format("{:.3g}", codec::false_accept_rate(level.codes, family.bits(), errors));
    };
    rows.push_back({{fmt::format("0-{}", level.codes - 1)},
                    {grouped(level.codes)},
                    {fmt::to_string(level.min_hamming)},
                    {fmt::to_string(report.stats.levels[i].min_hamming)},
                    {fmt::to_string(safe)},
                    {rate(0)},
                    {rate(std::min(2, family.bits()))},
                    {rate(safe)},
                    {grouped(report.stats.levels[i].passing)}});
  }
  return "<section id=\"levels\">\n<h2>Levels</h2>\n<p>The first ids are farther apart than all of "
         "them: who needs few tags takes them from the front, and decodes those ids only "
         "(<code>--ids</code>). The shares are those of random words taken for a tag.</p>\n" +
         html_table("Levels",
                    {{"ids"},
                     {"tags"},
                     {"distance"},
                     {"found"},
                     {"safe radius"},
                     {"at 0 bits"},
                     {"at 2 bits"},
                     {"at safe radius"},
                     {"complex enough"}},
                    rows) +
         "</section>\n";
}

/// The first tag with its two sizes marked.
std::string size_drawing(const codec::Family& family) {
  const codec::Layout& layout = family.layout();
  const int width = layout.width();
  const int offset = layout.border_offset();
  const auto measure = [](int from, int to, double y, const char* name) {
    return fmt::format(
        "<path class=\"axis\" style=\"stroke-width:.08\" d=\"M{0} {2:.2f}v.7m0-.35H{1}m0-.35v.7\">"
        "</path><text x=\"{3:.2f}\" y=\"{4:.2f}\" text-anchor=\"middle\" style=\"font-size:.75px\">"
        "{5}</text>",
        from, to, y, (from + to) / 2.0, y - 0.15, name);
  };
  return fmt::format(
             "<svg class=\"chart tag\" viewBox=\"-1.5 -4 {0} {1}\" role=\"img\"><title>edge is the "
             "side of the border square, outer that of the whole tag</title>"
             "<path class=\"paper\" d=\"M-1-1h{2}v{2}h-{2}z\"></path>{3}"
             "<path class=\"ink\" d=\"{4}\"></path>",
             width + 3, width + 5.5, width + 2,
             fmt::format("<path class=\"blank\" d=\"{}\"></path>", blank_path(layout)),
             black_path(codec::tag_cells(layout, family.codeword(0)))) +
         measure(0, width, -3, "outer") + measure(offset, width - offset, -1.75, "edge") +
         "</svg>\n";
}

std::string sizes(const codec::Family& family) {
  const double cells_outer = family.layout().width();
  const double cells_edge = family.layout().width_at_border();
  std::vector<std::vector<TableCell>> rows;
  for (const double edge : {10.0, 20.0, 40.0, 80.0, 100.0, 160.0, 200.0}) {
    const double cell = edge / cells_edge;
    rows.push_back({{draw::format_mm(edge)},
                    {draw::format_mm(cell * cells_outer)},
                    {draw::format_mm(cell * (cells_outer + 2))},
                    {draw::format_mm(cell)}});
  }
  return fmt::format(
      "<section id=\"sizes\">\n<h2>Sizes</h2>\n<p><strong>Edge</strong> is the side of the square "
      "that a detector finds, {:.0f} cells, which pose estimation calls the tag's size; "
      "<strong>outer</strong> is the side of the whole tag, {:.0f} cells. Around it one cell of "
      "white is to stay free.</p>\n<div class=\"sizes\">\n{}{}</div>\n</section>\n",
      cells_edge, cells_outer, size_drawing(family),
      html_table("Sizes", {{"edge"}, {"outer"}, {"with quiet zone"}, {"cell"}}, rows));
}

std::string commands(const FamilyReport& report, const std::string& source,
                     const std::string& convert) {
  const codec::Family& family = *report.family;
  const std::string name = shell_word(source);
  const std::size_t last = std::min<std::size_t>(family.size(), 12) - 1;
  const std::string first = convert.empty() ? "" : fmt::format("{}\n", convert);
  const int radius = std::min(2, report.safe_errors().value_or(0));
  return fmt::format(
      "<section id=\"use\">\n<h2>Printing and finding</h2>\n<pre>{}</pre>\n</section>\n",
      escaped(fmt::format("{0}tagmint sheet {1} --edge 40mm --ids 0-{2} -o tags.pdf\n"
                          "tagmint detect --family {1} --max-hamming {3} picture.png\n"
                          "tagmint encode {1} 0\n"
                          "tagmint check {1}\n"
                          "tagmint convert {1} -o {4}.c",
                          first, name, last, radius, family.name())));
}

std::string lookup(const FamilyReport& report) {
  std::vector<std::vector<TableCell>> rows;
  for (const LookupMemory& memory : report.lookup) {
    rows.push_back({{engine_name(memory.engine), true},
                    {fmt::to_string(memory.max_errors)},
                    {fmt::format("{:.1f} KiB", static_cast<double>(memory.bytes) / 1024.0)}});
  }
  return "<section id=\"memory\">\n<h2>Memory of the lookup</h2>\n" +
         html_table("Memory of the lookup", {{"engine", true}, {"corrected bits"}, {"memory"}},
                    rows) +
         "</section>\n";
}

}  // namespace

std::string family_page(const FamilyReport& report, const std::string& source,
                        const std::string& convert) {
  const codec::Family& family = *report.family;
  const bool nested = family.levels().size() > 1;
  std::string page = page_head(family.name() + " - tag family");
  page += fmt::format("<body>\n<header>\n<h1>{}</h1>\n{}", escaped(family.name()), lead(family));
  page += fmt::format(
      "<nav class=\"contents\" aria-label=\"Contents\"><a href=\"#facts\">Facts</a>{}"
      "<a href=\"#charts\">Charts</a><a href=\"#gallery\">Tags</a><a href=\"#sizes\">Sizes</a>"
      "<a href=\"#use\">Printing and finding</a></nav>\n</header>\n<main>\n",
      nested ? "<a href=\"#levels\">Levels</a>" : "");
  page += "<section id=\"facts\">\n" + hero(family) + warnings(report) + safe_radius_html(report) +
          summary(report) + "</section>\n" + levels(report);
  page += "<section id=\"charts\">\n<h2>Distances, complexity, false accepts</h2>\n" +
          report_charts_html(report) + "</section>\n";
  page += gallery_html(report) + sizes(family) + commands(report, source, convert) + lookup(report);
  page += page_foot();
  return page;
}

}  // namespace tagmint::cli
