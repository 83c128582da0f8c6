#include "cli/sheet_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "cli/options.h"

namespace tagmint::cli {
namespace {

constexpr int kMostInARow = 100000;
constexpr double kMostQuietCells = 100;

// Options with the same description share a line of the help.
constexpr const char* kSizeText = "side of the border square (pose's size), or of all";
constexpr const char* kSpaceText = "around the page; between tags";
constexpr const char* kGridText = "of a page; default as many as fit";
constexpr const char* kRulerText = "on every page, or none; default: where it fits";
constexpr const char* kReverseText = "ink for white, not black; hairlines for cutters";
constexpr const char* kPixelText = "whole dots a cell; or exact size";
constexpr const char* kTrialText = "read back what was written; or only tell the plan";
constexpr const char* kPaperText = "a0..a6, letter, legal, tabloid, WxHmm";

void add_tag_options(CLI::App& app, SheetArguments& o) {
  app.add_option("FAMILY[:EDGE[:IDS]]", o.tags, "bundled family or file, like tag36h11:40mm:0-9")
      ->required();
  app.add_option("--ids", o.ids, "of tags without their own, 0-9,12,20-; default all")
      ->type_name("LIST");
  CLI::Option* const edge = app.add_option("--edge", o.edge, kSizeText)->type_name("LEN");
  app.add_option("--outer", o.outer, kSizeText)->type_name("LEN")->excludes(edge);
  app.add_option("--quiet-zone", o.quiet_zone_cells, "white around each tag, in cells")
      ->check(number_between(0, kMostQuietCells))
      ->type_name("N")
      ->default_str("1");
  app.add_option("--label", o.label, "below tags: {family} {id:05} {edge} {outer}, or none")
      ->type_name("FORMAT");
}

void add_page_options(CLI::App& app, SheetArguments& o) {
  app.add_option("--paper", o.paper, kPaperText)->type_name("P")->capture_default_str();
  app.add_flag("--landscape", o.landscape, kPaperText);
  app.add_option("--margin", o.margin, kSpaceText)
      ->type_name("LEN")
      ->default_str(kDefaultSheetMargin);
  app.add_option("--gap", o.gap, kSpaceText)->type_name("LEN")->capture_default_str();
  for (const auto& [name, count] : {std::pair{"--columns", &o.columns}, {"--rows", &o.rows}}) {
    app.add_option(name, *count, kGridText)
        ->check(CLI::Range(1, kMostInARow))
        ->type_name("N")
        ->default_str("");
  }
  app.add_option("--title", o.title, "on top of every page")->type_name("TEXT");
  CLI::Option* const ruler = app.add_flag("--ruler", o.ruler, kRulerText);
  app.add_flag("--no-ruler", o.no_ruler, kRulerText)->excludes(ruler);
  app.add_flag("--cut-marks", o.cut_marks, "at the corners of each tag, in the gaps");
  add_choice(app, "--cut-lines", o.cut_lines, {"square", "rounded", "circle"},
             "around each tag: square, rounded or circle")
      ->type_name("SHAPE");
}

void add_ink_options(CLI::App& app, SheetArguments& o) {
  add_choice(app, "--color", o.color, {"gray", "k"}, "black as gray level or K plate")
      ->default_str("gray");
  add_choice(app, "--ground", o.ground, {"white", "none"},
             "default white on screens, none on paper");
  app.add_flag("--invert", o.invert, kReverseText);
  app.add_flag("--outline", o.outline, kReverseText);
  app.add_option("--dpi", o.dpi, kPixelText)
      ->check(number_between(1, 100000))
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("--exact", o.exact, kPixelText);
  add_choice(app, "--depth", o.depth, {"1", "8"}, "bits a pixel of pictures")->default_str("8");
}

void add_file_options(CLI::App& app, SheetArguments& o) {
  add_choice(app, "--format", o.format, {"pdf", "svg", "png", "tiff", "ps", "eps", "dxf"},
             "pdf, svg, png, tiff, ps, eps, dxf; default by FILE")
      ->type_name("F");
  add_output(app, o.output, "with {page} one a page, with {id} one a tag")
      ->required()
      ->default_str("");
  app.add_flag("--verify", o.verify, kTrialText);
  app.add_flag("--dry-run", o.dry_run, kTrialText);
}

/// Puts the options that were added since into a section of the help.
void group_from(CLI::App& app, std::size_t first, const char* name) {
  const std::vector<CLI::Option*> options = app.get_options();
  for (std::size_t i = first; i < options.size(); ++i) options[i]->group(name);
}

}  // namespace

bool SheetArguments::is_given(const std::string& name) const {
  return std::find(given.begin(), given.end(), name) != given.end();
}

std::function<void()> add_sheet_options(CLI::App& app, std::shared_ptr<SheetArguments> arguments) {
  using Adder = void (*)(CLI::App&, SheetArguments&);
  const std::pair<const char*, Adder> sections[] = {{"Tags", add_tag_options},
                                                    {"Page", add_page_options},
                                                    {"Ink", add_ink_options},
                                                    {"File", add_file_options}};
  for (const auto& [name, add] : sections) {
    const std::size_t first = app.get_options().size();
    add(app, *arguments);
    group_from(app, first, name);
  }
  return [&app, arguments] {
    for (const CLI::Option* option : app.get_options()) {
      if (option->count() > 0) arguments->given.push_back(option->get_name());
    }
  };
}

}  // namespace tagmint::cli
