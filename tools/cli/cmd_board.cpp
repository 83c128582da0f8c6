#include "cli/cmd_board.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "board/board_notes.h"
#include "board/board_writer.h"
#include "board/bundle.h"
#include "board/clearance.h"
#include "board/grid_board.h"
#include "cli/board_configs.h"
#include "cli/board_input.h"
#include "cli/drawing_target.h"
#include "cli/id_list.h"
#include "cli/length.h"
#include "cli/options.h"
#include "cli/paper.h"
#include "cli/terminal.h"
#include "draw/units.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

using board::Board;

/// The options as they were typed; empty where they were not.
struct Options {
  std::string family;
  std::string grid;
  std::string edge;
  std::string outer;
  std::string spacing;
  std::string style = "plain";
  int border = 0;  // 0 = the style's
  std::uint64_t first_id = 0;
  std::string ids;
  std::vector<std::string> nested;
  std::vector<std::string> tags;
  std::string bundle;
  std::vector<std::string> configs;
  std::string paper;
  bool landscape = false;
  std::string margin;
  bool no_notes = false;
  double dpi = 300.0;
  std::string format;
  std::string output;
  std::vector<std::string> grid_options;  // those given that only a grid has
};

constexpr const char* kPaperMargin = "10mm";
constexpr const char* kOwnMargin = "0mm";
constexpr int kKalibrBorder = 2;
constexpr double kUsualSpacing = 0.3;

board::Style style_of(const Options& options) {
  return options.style == "kalibr" ? board::Style::Kalibr : board::Style::Plain;
}

double edge_mm(const Options& options, const codec::Layout& layout) {
  const bool outer = !options.outer.empty();
  if (!outer && options.edge.empty()) {
    throw UsageError("the size of the tags is missing", "--edge",
                     "give --edge 40mm (side of the border square) or --outer 50mm (side of the "
                     "whole tag)");
  }
  const double edge = outer ? draw::edge_of_outer(layout, parse_length_mm(options.outer, "--outer"))
                            : parse_length_mm(options.edge, "--edge");
  if (edge < kLeastEdgeMm) {
    throw UsageError(fmt::format("tags with an edge below {} mm cannot be printed", kLeastEdgeMm),
                     outer ? "--outer" : "--edge", "give a larger size, like 40mm");
  }
  return edge;
}

/// The layout as it will be printed, for sizes; plan_grid() refuses what cannot be.
codec::Layout printed_layout(const codec::Layout& layout, int border) {
  return board::is_black_on_white(layout) ? board::with_border(layout, border) : layout;
}

std::vector<codec::TagId> ids_of(const Options& options, const codec::Family& family,
                                 std::size_t places) {
  if (!options.ids.empty()) return parse_id_list(options.ids, family.size());
  if (options.first_id >= family.size() || family.size() - options.first_id < places) {
    throw UsageError(fmt::format("the grid has {} places, and {} has ids 0-{}", places,
                                 family.name(), family.size() - 1),
                     "--grid", "take a smaller grid, a lower --first-id or a larger family");
  }
  std::vector<codec::TagId> ids(places);
  std::iota(ids.begin(), ids.end(), static_cast<codec::TagId>(options.first_id));
  return ids;
}

/// The usual gap where it is wide enough for the tags, else the least that is.
double usual_gap_mm(const codec::Layout& layout, double edge) {
  return std::max(kUsualSpacing * edge, board::least_gap_mm(layout, edge));
}

Board grid_board(const Options& options) {
  if (options.family.empty()) {
    throw UsageError("FAMILY is missing", "--grid", "name the family of the grid, like tag36h11");
  }
  const codec::SharedFamily family = codec::load_family(options.family);
  const GridSize size = parse_grid(options.grid);
  board::Grid grid{.columns = size.columns, .rows = size.rows};
  grid.style = style_of(options);
  const int usual = grid.style == board::Style::Kalibr ? kKalibrBorder : 1;
  grid.border_cells = options.border > 0 ? options.border : usual;
  const codec::Layout layout = printed_layout(family->layout(), grid.border_cells);
  grid.edge_mm = edge_mm(options, layout);
  grid.gap_mm = options.spacing.empty() ? usual_gap_mm(layout, grid.edge_mm)
                                        : parse_spacing_mm(options.spacing, grid.edge_mm);
  std::vector<draw::NestedRequest> nested;
  for (const std::string& text : options.nested) nested.push_back(parse_nested(text));
  const std::size_t places = static_cast<std::size_t>(size.columns) * size.rows;
  return board::plan_grid(family, grid, ids_of(options, *family, places), nested);
}

Board bundle_board(const Options& options) {
  if (!options.family.empty() || !options.grid_options.empty()) {
    throw UsageError(fmt::format("{} has no meaning for a bundle",
                                 options.family.empty() ? options.grid_options[0] : options.family),
                     options.bundle.empty() ? "--tag" : "--bundle",
                     "every tag of a bundle has its own family, size and place; leave it out");
  }
  std::vector<board::BoardTag> tags;
  if (!options.bundle.empty()) tags = read_bundle(options.bundle);
  for (const std::string& text : options.tags) tags.push_back(parse_bundle_tag(text));
  return board::plan_bundle(std::move(tags));
}

Board plan_board(const Options& options) {
  const bool bundle = !options.tags.empty() || !options.bundle.empty();
  if (bundle && options.grid.empty()) return bundle_board(options);
  if (options.grid.empty() || bundle) {
    throw UsageError(bundle ? "a board is a grid or a bundle, not both" : "no board is told",
                     "--grid",
                     "give FAMILY --grid 6x6 --edge 40mm, or tags with their places by --tag or "
                     "--bundle");
  }
  return grid_board(options);
}

board::BoardPage plan_page(const Options& options, const Board& board) {
  std::vector<std::string> lines;
  if (!options.no_notes) lines = board::board_notes(board);
  if (options.paper.empty()) {
    if (options.landscape) {
      throw UsageError("there is no paper to turn", "--landscape", "give --paper, or leave it out");
    }
    const double margin =
        parse_length_mm(options.margin.empty() ? kOwnMargin : options.margin, "--margin");
    return board::page_of_own_size(board, margin, std::move(lines));
  }
  PaperSize paper = parse_paper(options.paper);
  if (options.landscape) std::swap(paper.width_mm, paper.height_mm);
  const double margin =
      parse_length_mm(options.margin.empty() ? kPaperMargin : options.margin, "--margin");
  return board::page_on_paper(board, paper.width_mm, paper.height_mm, margin, std::move(lines));
}

/// What a person needs to set up a detector, and what was written.
void report(const Board& board, const board::BoardPage& page, const std::string& output,
            const std::vector<ConfigTarget>& configs) {
  fmt::print(stderr, "{}: {} tag{} on a page of {} x {}\n", is_stdout(output) ? "stdout" : output,
             board.tags.size(), board.tags.size() == 1 ? "" : "s", draw::format_mm(page.width_mm),
             draw::format_mm(page.height_mm));
  for (const std::string& line : board::board_facts(board)) fmt::print(stderr, "  {}\n", line);
  for (const ConfigTarget& config : configs) {
    fmt::print(stderr, "{}: {}\n", is_stdout(config.path) ? "stdout" : config.path,
               board::name_of(config.kind));
  }
}

/// Programs that follow connected areas are given a board whose squares join its tags.
void warn_of_squares(const Board& board, const std::vector<ConfigTarget>& configs,
                     const Common& common) {
  if (board.squares.empty()) return;
  for (const ConfigTarget& config : configs) {
    if (config.kind == board::ConfigKind::Kalibr || config.kind == board::ConfigKind::Tagmint) {
      continue;
    }
    say(common, fmt::format("warning: {} uses a detector that follows connected areas and misses "
                            "most tags of a board whose squares join them ({}); print it with "
                            "--style plain",
                            board::name_of(config.kind), config.path));
  }
}

int run(const Options& options, const Common& common) try {
  const draw::FileKind kind = drawing_kind(options.format, options.output);
  const Board board = plan_board(options);
  const board::BoardPage page = plan_page(options, board);
  std::vector<ConfigTarget> configs;
  std::vector<Result> results = {{options.output, {}}};
  for (const std::string& text : options.configs) {
    configs.push_back(parse_config_target(text, style_of(options)));
    results.push_back({configs.back().path, board::board_config(configs.back().kind, board)});
  }
  require_writable(results);
  warn_of_squares(board, configs, common);
  draw::FileOptions file;
  file.title = fmt::format("board of {} tags", board.tags.size());
  file.dpi = options.dpi;
  results[0].content = board::board_file(board, page, kind, file);
  write_results(results);
  if (!common.quiet) report(board, page, options.output, configs);
  return kDone;
} catch (const draw::DoesNotFit& fault) {
  throw UsageError(fault.what(), "", "");
} catch (const board::NotExpressible& fault) {
  throw UsageError(fault.what(), "", "");
} catch (const std::invalid_argument& fault) {
  throw usage_error(fault, "board");
}

/// Options of a grid; those given are remembered, since bundles have none of them.
std::vector<CLI::Option*> add_grid_options(CLI::App& app, Options& o) {
  std::vector<CLI::Option*> added;
  const auto text = [&](const char* name, std::string& value, const char* type, const char* about) {
    added.push_back(app.add_option(name, value, about)->type_name(type));
    return added.back();
  };
  app.add_option("--grid", o.grid, "columns x rows, like 6x7")->type_name("CxR");
  CLI::Option* edge = text("--edge", o.edge, "LEN", "side of the border squares (pose's size)");
  text("--outer", o.outer, "LEN", "side of the whole tags")->excludes(edge);
  text("--spacing", o.spacing, "F|LEN", "gap / edge, or the gap; default 0.3 or what tags need")
      ->capture_default_str();
  added.push_back(add_choice(app, "--style", o.style, {"plain", "kalibr"},
                             "kalibr: black squares, wide borders")
                      ->capture_default_str());
  added.push_back(app.add_option("--border", o.border, "cells of the black border")
                      ->check(CLI::Range(1, 4))
                      ->type_name("N")
                      ->default_str("1, kalibr: 2"));
  CLI::Option* first = app.add_option("--first-id", o.first_id, "ids count up from here")
                           ->type_name("N")
                           ->capture_default_str();
  added.push_back(first);
  text("--ids", o.ids, "LIST", "ids of the places")->excludes(first);
  added.push_back(
      app.add_option("--nested", o.nested, "FAMILY:ID[:EDGE] in the holes, ids counting up")
          ->type_name("TAG")
          ->allow_extra_args(false));
  return added;
}

Runner set_up(CLI::App& app, const Common& common) {
  auto options = std::make_shared<Options>();
  Options& o = *options;
  app.add_option("FAMILY", o.family, "family of a grid");
  const std::vector<CLI::Option*> grid_options = add_grid_options(app, o);
  app.add_option("--tag", o.tags, "FAMILY:ID:EDGE@X,Y[,TURN] of a bundle; repeatable")
      ->type_name("TAG")
      ->allow_extra_args(false);
  app.add_option("--bundle", o.bundle, "tags of a bundle from a JSON file")->type_name("FILE");
  app.add_option("--config", o.configs, "FILE or KIND:FILE: kalibr, ros1, ros2, wpilib, tagmint")
      ->type_name("FILE");
  app.add_option("--paper", o.paper, "a0..a6, ...; default: a page of the board's size")
      ->type_name("P");
  app.add_flag("--landscape", o.landscape, "turn the paper");
  app.add_option("--margin", o.margin, "around the board; 0mm without --paper")
      ->type_name("LEN")
      ->default_str(kPaperMargin);
  app.add_flag("--no-notes", o.no_notes, "neither sizes nor ruler below the board");
  add_drawing_options(app, o.dpi, o.format);
  add_output(app, o.output, "the board")->required()->default_str("");
  return [options, grid_options, &common] {
    for (const CLI::Option* option : grid_options) {
      if (option->count() > 0) options->grid_options.push_back(option->get_name());
    }
    return run(*options, common);
  };
}

}  // namespace

Command board_command() {
  return {.name = "board",
          .summary = "calibration boards and bundles, with their configs",
          .examples = {"tagmint board tag36h11 --grid 6x6 --edge 88mm --config b.json -o b.pdf",
                       "tagmint board tag36h11 --grid 6x6 --edge 88mm --style kalibr "
                       "-o k.pdf"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
