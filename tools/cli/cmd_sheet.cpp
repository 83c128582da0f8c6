#include "cli/cmd_sheet.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/length.h"
#include "cli/options.h"
#include "cli/paper.h"
#include "cli/sheet_files.h"
#include "cli/tag_request.h"
#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"
#include "draw/units.h"

namespace tagmint::cli {
namespace {

/// The options as they were typed; empty or zero where they were not.
struct Options {
  std::vector<std::string> tags;
  std::string ids;
  std::string edge;
  std::string outer;
  std::string paper = "a4";
  bool landscape = false;
  std::string margin;
  std::string gap = "5mm";
  int columns = 0;
  int rows = 0;
  std::string label;
  bool cut_marks = false;
  bool ruler = false;
  std::string title;
  double dpi = 300.0;
  std::string format;
  std::string output;
  std::vector<std::string> page_options;  // those given that a page of one tag does not have
};

constexpr const char* kDefaultLabel = "{family}  {id}";
constexpr const char* kDefaultMargin = "10mm";

std::vector<draw::TagGroup> tag_groups(const Options& options) {
  TagDefaults defaults{.edge_mm = {}, .outer_mm = {}, .ids = options.ids};
  if (!options.edge.empty()) defaults.edge_mm = parse_length_mm(options.edge, "--edge");
  if (!options.outer.empty()) defaults.outer_mm = parse_length_mm(options.outer, "--outer");
  std::vector<draw::TagGroup> groups;
  for (const std::string& tag : options.tags) groups.push_back(resolve_tag_request(tag, defaults));
  return groups;
}

/// The label's format; nothing for "none". Pages of one tag have a label only when asked.
std::optional<draw::TextFormat> label_format(const Options& options, bool file_a_tag) {
  if (options.label == "none" || (options.label.empty() && file_a_tag)) return std::nullopt;
  return parse_option(
      [](std::string_view text) { return draw::TextFormat(text, draw::label_fields()); },
      options.label.empty() ? kDefaultLabel : options.label, "--label");
}

draw::SheetOptions page_layout(const Options& options, const draw::SheetDecor& decor,
                               const std::vector<draw::TagGroup>& groups) {
  PaperSize paper = parse_paper(options.paper);
  if (options.landscape) std::swap(paper.width_mm, paper.height_mm);
  return {.page_width_mm = paper.width_mm,
          .page_height_mm = paper.height_mm,
          .margin_mm =
              parse_length_mm(options.margin.empty() ? kDefaultMargin : options.margin, "--margin"),
          .gap_mm = parse_length_mm(options.gap, "--gap"),
          .columns = options.columns,
          .rows = options.rows,
          .label_mm = draw::label_height_mm(decor, groups),
          .header_mm = draw::header_height_mm(decor),
          .footer_mm = draw::footer_height_mm(decor, groups.size())};
}

std::string counted(std::size_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

/// "tag36h11: 12 tags, edge 40 mm, outer 50 mm"
std::string describe(const draw::TagGroup& group) {
  return fmt::format("{}: {}, edge {}, outer {}", group.family->name(),
                     counted(group.ids.size(), "tag"), draw::format_mm(group.edge_mm),
                     draw::format_mm(draw::outer_of_edge(group.family->layout(), group.edge_mm)));
}

/// One line a group: what a person needs to set up a detector, and to see what fits.
void report(const draw::SheetPlan& plan, const std::string& what) {
  fmt::print(stderr, "{}: {} on {} of {} x {}\n", what, counted(plan.tag_count(), "tag"),
             counted(plan.pages.size(), "page"), draw::format_mm(plan.options.page_width_mm),
             draw::format_mm(plan.options.page_height_mm));
  for (std::size_t i = 0; i < plan.groups.size(); ++i) {
    fmt::print(stderr, "  {}; a page takes {} x {}\n", describe(plan.groups[i]),
               plan.grids[i].columns, plan.grids[i].rows);
  }
}

int run_file_a_tag(const Options& options, const SheetTarget& target, draw::SheetDecor decor,
                   const std::vector<draw::TagGroup>& groups, const Common& common) {
  if (!options.page_options.empty()) {
    throw UsageError(fmt::format("{} has no meaning for one file a tag", options.page_options[0]),
                     target.pattern(),
                     "leave it out, or write to a name without {id} for sheets of many tags");
  }
  decor.notes = false;
  draw::SheetOptions page;
  page.margin_mm = parse_length_mm(options.margin.empty() ? "0mm" : options.margin, "--margin");
  page.label_mm = draw::label_height_mm(decor, groups);
  const std::size_t files = target.write_tags(groups, page, decor, options.dpi, common);
  if (common.quiet) return kDone;
  fmt::print(stderr, "{}: {} of one tag each\n", target.pattern(), counted(files, "file"));
  for (const draw::TagGroup& group : groups) fmt::print(stderr, "  {}\n", describe(group));
  return kDone;
}

/// Titles and labels are one line of text; a line break or a tab would be drawn as an empty box.
void require_one_line(const std::string& text, const char* option) {
  const bool control =
      std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (control) {
    throw UsageError("the text holds a line break or another control character", option,
                     "write one line of plain text");
  }
}

int run(const Options& options, const Common& common) try {
  require_one_line(options.title, "--title");
  require_one_line(options.label, "--label");
  const SheetTarget target(options.output, options.format);
  draw::SheetDecor decor{.label = label_format(options, target.is_file_a_tag()),
                         .title = options.title,
                         .notes = true,
                         .ruler = options.ruler,
                         .cut_marks = options.cut_marks};
  const std::vector<draw::TagGroup> groups = tag_groups(options);
  if (target.is_file_a_tag()) return run_file_a_tag(options, target, decor, groups, common);
  const draw::SheetOptions page = page_layout(options, decor, groups);
  if (options.cut_marks && page.gap_mm <= 0) {
    throw UsageError("cut marks stand in the gap between tags, which is 0 mm", "--cut-marks",
                     "give a gap, for example --gap 5mm");
  }
  const draw::SheetPlan plan = draw::plan_sheet(groups, page);
  target.write_pages(plan, decor, options.dpi, common);
  if (!common.quiet) report(plan, target.pattern() == "-" ? "stdout" : target.pattern());
  return kDone;
} catch (const draw::DoesNotFit& fault) {
  throw UsageError(fault.what(), "", "");
} catch (const std::invalid_argument& fault) {
  throw usage_error(fault, "sheet");
}

Runner set_up(CLI::App& app, const Common& common) {
  auto options = std::make_shared<Options>();
  Options& o = *options;
  const auto length = [&app](const char* name, std::string& value, const char* description) {
    return app.add_option(name, value, description)->type_name("LEN");
  };
  app.add_option("FAMILY[:EDGE[:IDS]]", o.tags,
                 "bundled family or family file, with its own edge and ids, like tag36h11:40mm:0-9")
      ->required();
  app.add_option("--ids", o.ids, "ids of families that give none, like 0-9,12,20-; default all")
      ->type_name("LIST");
  auto* edge = length("--edge", o.edge, "side of the border square (what pose calls size)");
  length("--outer", o.outer, "side of the whole tag")->excludes(edge);
  std::vector<CLI::Option*> page_only = {
      app.add_option("--paper", o.paper, "a0..a6, letter, legal or WxHmm")
          ->type_name("P")
          ->capture_default_str(),
      app.add_flag("--landscape", o.landscape, "turn the paper"),
      length("--gap", o.gap, "between tags")->capture_default_str()};
  length("--margin", o.margin, "left free on all sides of the page")->default_str(kDefaultMargin);
  for (const auto& [name, count] : {std::pair{"--columns", &o.columns}, {"--rows", &o.rows}}) {
    page_only.push_back(app.add_option(name, *count, "of a page; default as many as fit")
                            ->check(CLI::Range(1, 100000))
                            ->type_name("N")
                            ->default_str(""));
  }
  app.add_option("--label", o.label,
                 "text below tags: {family} {id} {id:05} {edge} {outer}, or none")
      ->type_name("FORMAT")
      ->default_str(kDefaultLabel);
  page_only.push_back(app.add_flag("--cut-marks", o.cut_marks, "mark where to cut, in the gaps"));
  page_only.push_back(app.add_flag("--ruler", o.ruler, "print a ruler to check the size with"));
  page_only.push_back(
      app.add_option("--title", o.title, "on top of every page")->type_name("TEXT"));
  app.add_option("--dpi", o.dpi, "pixels per inch of PNG files")
      ->check(number_between(1, 100000))
      ->type_name("N")
      ->capture_default_str();
  add_choice(app, "--format", o.format, {"pdf", "svg", "png"}, "default: by the extension of -o");
  add_output(app, o.output, "FILE; {page} in its name: one a page, {id}: one a tag")
      ->required()
      ->default_str("");
  return [options, page_only, &common] {
    for (const CLI::Option* option : page_only) {
      if (option->count() > 0) options->page_options.push_back(option->get_name());
    }
    return run(*options, common);
  };
}

}  // namespace

Command sheet_command() {
  return {.name = "sheet",
          .summary = "print tags at exact physical size: PDF, SVG, PNG",
          .examples = {"tagmint sheet tag36h11 --edge 40mm --ids 0-11 --cut-marks -o tags.pdf",
                       "tagmint sheet tag25h9 --outer 50mm -o 'tags/{family}-{id:05}.svg'"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
