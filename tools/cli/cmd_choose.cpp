#include "cli/cmd_choose.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/camera_option.h"
#include "cli/choose_plan.h"
#include "cli/choose_report.h"
#include "cli/length.h"
#include "cli/number.h"
#include "cli/options.h"
#include "cli/output.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

/// The options as they were typed; empty where they were not.
struct Options {
  std::string tags;
  std::string edge;
  std::string outer;
  std::string camera;
  std::string distance;
  std::vector<std::string> families;
  std::string format;
  std::string output;
};

double positive_length_mm(const std::string& text, const char* option) {
  const double length_mm = parse_length_mm(text, option);
  if (length_mm > 0) return length_mm;
  throw UsageError("the length must be above 0", option, "write it with its unit, like 40mm");
}

TagUse use_of(const Options& options) {
  if (options.edge.empty() == options.outer.empty()) {
    throw UsageError(options.edge.empty() ? "the size of the tags is missing"
                                          : "the size of the tags is given twice",
                     "--edge",
                     "give --edge (side of the border square) or --outer (side of the whole tag)");
  }
  const detect::Camera camera = parse_camera(options.camera, "");
  TagUse use;
  use.tags = parse_count(options.tags, "--tags");
  use.outer = options.edge.empty();
  use.size_mm = use.outer ? positive_length_mm(options.outer, "--outer")
                          : positive_length_mm(options.edge, "--edge");
  // Cells are as small as their smaller side.
  use.focal_px = std::min(camera.fx, camera.fy);
  use.distance_mm = positive_length_mm(options.distance, "--distance");
  return use;
}

/// The bundled families and those asked for besides.
std::vector<Candidate> candidates_of(const std::vector<std::string>& more) {
  std::vector<Candidate> candidates;
  for (const std::string& name : codec::family_names()) {
    candidates.push_back({name, codec::find_family(name)});
  }
  for (const std::string& path : more) {
    codec::SharedFamily family = codec::load_family(path);
    const bool known = std::any_of(candidates.begin(), candidates.end(),
                                   [&](const Candidate& c) { return c.family == family; });
    if (!known) candidates.push_back({path, std::move(family)});
  }
  return candidates;
}

int run(const Options& options, const Common& common) {
  const std::vector<std::string> formats = {"text", "json"};
  const std::string format = choose_format(options.format, options.output, formats, "text");
  const TagUse use = use_of(options);
  const ChoosePlan plan = choose_families(candidates_of(options.families), use, common.threads);
  write_output(options.output, format == "json" ? choose_json(plan, use) : choose_text(plan, use));
  const bool readable =
      !plan.ranked.empty() && plan.ranked.front().readability != Readability::Beyond;
  return readable ? kDone : kAnswerIsNo;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "Ranked by, in turn: read at that distance with half as much again in reserve, without, not "
      "at all; false accepts at most those of tag36h11 with two corrected bits; the share of "
      "cells that may be wrong; the share that mixes two tags up; size of the whole tag. Exit "
      "code 1 when no family can be read there.");
  auto options = std::make_shared<Options>();
  app.add_option("--tags", options->tags, "different tags needed")->required()->type_name("N");
  app.add_option("--edge", options->edge, "side of the border square, like 40mm")->type_name("LEN");
  app.add_option("--outer", options->outer, "or side of the whole tag")->type_name("LEN");
  app.add_option("--camera", options->camera, "focal lengths and centre, px")
      ->required()
      ->type_name("FX,FY,CX,CY");
  app.add_option("--distance", options->distance, "from the camera to the tag, like 1.5m")
      ->required()
      ->type_name("LEN");
  app.add_option("--family", options->families, "a family file to rank too; give it again for more")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_format(app, options->format, {"text", "json"}, "text");
  add_output(app, options->output);
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command choose_command() {
  return {.name = "choose",
          .summary = "which family, level and ids suit a use",
          .examples = {"tagmint choose --tags 50 --edge 40mm --camera 600,600,320,240 "
                       "--distance 1m",
                       "tagmint choose --tags 9 --outer 5cm --camera 900,900,640,360 "
                       "--distance 3m"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
