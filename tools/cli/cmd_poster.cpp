#include "cli/cmd_poster.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/board_input.h"
#include "cli/drawing_target.h"
#include "cli/id_list.h"
#include "cli/length.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/paper.h"
#include "cli/progress.h"
#include "draw/units.h"
#include "poster/poster_map.h"
#include "poster/poster_writer.h"
#include "tagmint/codec/atomic_file.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

/// The options as they were typed; empty where they were not.
struct Options {
  std::string family;
  std::string id;
  std::string edge;
  std::string outer;
  std::vector<std::string> nested;
  std::string paper = "a4";
  bool landscape = false;
  bool portrait = false;
  std::string margin = "10mm";
  std::string overlap = "10mm";
  std::string format;
  std::string output;
};

/// PDF and PostScript: what holds several pages.
draw::FileKind poster_kind(const Options& options) {
  const std::vector<std::string> words = {"pdf", "ps"};
  const std::string word = choose_format(options.format, options.output, words, "pdf");
  return *draw::file_kind_of(word);
}

poster::PosterTag poster_tag(const Options& options) {
  const codec::SharedFamily family = codec::load_family(options.family);
  const std::vector<codec::TagId> ids = parse_id_list(options.id, family->size(), "ID");
  if (ids.size() != 1) {
    throw UsageError(fmt::format("'{}' is more than one id", options.id), "ID",
                     "a poster has one tag; make one poster for each");
  }
  const bool outer = !options.outer.empty();
  if (!outer && options.edge.empty()) {
    throw UsageError("the size of the tag is missing", "--edge",
                     "give --edge 400mm (side of the border square) or --outer 500mm (side of the "
                     "whole tag)");
  }
  const double edge =
      outer ? draw::edge_of_outer(family->layout(), parse_length_mm(options.outer, "--outer"))
            : parse_length_mm(options.edge, "--edge");
  if (edge < kLeastEdgeMm) {
    throw UsageError(fmt::format("tags with an edge below {} mm cannot be printed", kLeastEdgeMm),
                     outer ? "--outer" : "--edge", "give a larger size, like 400mm");
  }
  return {family, ids[0], edge};
}

poster::PosterPlan plan(const Options& options) {
  const PaperSize paper = parse_paper(options.paper);
  poster::PosterOptions page{.paper_width_mm = paper.width_mm,
                             .paper_height_mm = paper.height_mm,
                             .margin_mm = parse_length_mm(options.margin, "--margin"),
                             .overlap_mm = parse_length_mm(options.overlap, "--overlap")};
  if (options.portrait) page.orientation = poster::Orientation::AsGiven;
  if (options.landscape) page.orientation = poster::Orientation::Turned;
  std::vector<draw::NestedRequest> nested;
  for (const std::string& text : options.nested) nested.push_back(parse_nested(text));
  return poster::plan_poster(poster_tag(options), nested, page);
}

void write(const poster::PosterPlan& plan, draw::FileKind kind, const std::string& output,
           const Common& common) {
  require_writable(output);
  draw::FileOptions file;
  file.title = fmt::format("{} {}", plan.tags[0].family->name(), plan.tags[0].id);
  Progress progress(common, "poster", "pages");
  const auto total = static_cast<double>(plan.pages.size() + 1);
  const auto tell = [&](std::size_t done) { progress.update(static_cast<double>(done), total); };
  if (is_stdout(output)) {
    poster::write_poster(plan, kind, file, write_stdout, tell);
    return;
  }
  codec::AtomicFile target(output);
  poster::write_poster(
      plan, kind, file, [&](std::string_view bytes) { target.write(bytes); }, tell);
  target.publish();
}

int run(const Options& options, const Common& common) try {
  const draw::FileKind kind = poster_kind(options);
  const poster::PosterPlan poster = plan(options);
  write(poster, kind, options.output, common);
  if (common.quiet) return kDone;
  fmt::print(stderr, "{}: {} pages, the first is the map\n",
             is_stdout(options.output) ? "stdout" : options.output, poster.pages.size() + 1);
  for (const std::string& line : poster::poster_facts(poster)) {
    fmt::print(stderr, "  {}\n", line);
  }
  return kDone;
} catch (const draw::DoesNotFit& fault) {
  throw UsageError(fault.what(), "", "");
} catch (const std::invalid_argument& fault) {
  throw usage_error(fault, "poster");
}

Runner set_up(CLI::App& app, const Common& common) {
  auto options = std::make_shared<Options>();
  Options& o = *options;
  add_family(app, o.family);
  app.add_option("ID", o.id, "id of the tag")->required();
  const auto text = [&](const char* name, std::string& value, const char* type, const char* about) {
    return app.add_option(name, value, about)->type_name(type);
  };
  CLI::Option* edge = text("--edge", o.edge, "LEN", "side of the border square");
  text("--outer", o.outer, "LEN", "side of the whole tag")->excludes(edge);
  app.add_option("--nested", o.nested, "FAMILY:ID[:EDGE] in its hole; repeatable, inwards")
      ->type_name("TAG")
      ->allow_extra_args(false);
  text("--paper", o.paper, "P", "a0..a6, letter, legal, tabloid or WxHmm")->capture_default_str();
  CLI::Option* landscape = app.add_flag("--landscape", o.landscape,
                                        "turn the paper of all rows; default: each row as it "
                                        "takes fewest pages");
  app.add_flag("--portrait", o.portrait, "turn it in no row")->excludes(landscape);
  text("--margin", o.margin, "LEN", "around each page, for marks and page numbers; at least 6mm")
      ->capture_default_str();
  text("--overlap", o.overlap, "LEN", "what neighbouring pages show both")->capture_default_str();
  add_choice(app, "--format", o.format, {"pdf", "ps"}, "default: by the extension of -o");
  add_output(app, o.output, "all pages, after a map of them")->required()->default_str("");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command poster_command() {
  return {.name = "poster",
          .summary = "one tag larger than the paper, over many pages",
          .examples = {"tagmint poster tag36h11 7 --edge 600mm -o poster.pdf",
                       "tagmint poster tagCustom48h12 1 --outer 2m --nested tag36h11:7 -o pad.pdf"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
