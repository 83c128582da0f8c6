#include "cli/cmd_detect.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/detect_plan.h"
#include "cli/detect_run.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/terminal.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::cli {
namespace {

/// Takes the results as they come: to stdout at once, to a file when all are there.
class ResultWriter {
 public:
  ResultWriter(const DetectPlan& plan, std::string target)
      : plan_(plan), target_(std::move(target)) {
    if (!is_stdout(target_)) require_writable(target_);
    if (plan_.format == "csv") put(io::csv_header(plan_.poses.has_value()));
  }
  void write(const io::ImageResult& result) {
    put(plan_.format == "jsonl" ? format_jsonl(result)
        : plan_.format == "csv" ? format_csv(result, plan_.poses.has_value())
                                : format_text(result));
  }
  void finish() {
    if (!is_stdout(target_)) write_output(target_, held_);
  }

 private:
  void put(const std::string& text) {
    if (is_stdout(target_)) {
      if (!text.empty()) write_output(target_, text);
    } else {
      held_ += text;
    }
  }

  const DetectPlan& plan_;
  std::string target_;
  std::string held_;
};

int run(const DetectArguments& arguments, const Common& common) {
  const DetectPlan plan = plan_detection(arguments);
  ResultWriter writer(plan, arguments.output);
  Progress progress(common, "detect", "images");
  detect::DetectStats stats;
  std::size_t done = 0;
  bool unreadable = false;
  bool without_tags = false;
  run_detection(plan, common.threads, [&](DetectOutcome&& outcome) {
    progress.clear();
    if (outcome.result.error) {
      unreadable = true;
      print_error(*outcome.result.error);
    } else if (outcome.result.tags.empty()) {
      without_tags = true;
    }
    writer.write(outcome.result);
    stats += outcome.stats;
    progress.update(static_cast<double>(++done), static_cast<double>(plan.tasks.size()));
  });
  progress.clear();
  writer.finish();
  if (arguments.stats) std::fputs(stats_text(stats, plan.detector.algorithm).c_str(), stderr);
  if (unreadable) return kBadInput;
  return arguments.require && without_tags ? kAnswerIsNo : kDone;
}

void add_search_options(CLI::App& app, DetectArguments& arguments) {
  app.add_option("--family", arguments.families, "family to look for; give it again for more")
      ->required()
      ->type_name("FAMILY")
      ->allow_extra_args(false);
  add_decoder_options(app, arguments.decoding);
  add_choice(app, "--algorithm", arguments.algorithm, {"tracker", "paper"},
             "tracker or paper finds quads")
      ->type_name("NAME");
  app.add_option("--decimate", arguments.detector.decimate, "look in an image X times smaller")
      ->type_name("X")
      ->check(number_between(1, 1000));
  app.add_option("--blur", arguments.detector.blur_sigma_px, "blur by S px; below 0: sharpen")
      ->type_name("S")
      ->check(number_between(-100, 100));
  app.add_option("--min-side", arguments.detector.min_side_px,
                 "least side of a border square in px")
      ->type_name("PX")
      ->check(number_between(0, 1e6))
      ->capture_default_str();
  app.add_option("--min-contrast", arguments.detector.min_contrast,
                 "no tag has less contrast, gray levels")
      ->type_name("N")
      ->check(number_between(0, 255))
      ->capture_default_str();
  app.add_flag("--fixed-contrast", arguments.fixed_contrast,
               "do not raise --min-contrast with the picture's noise");
  app.add_option("--min-margin", arguments.detector.min_decision_margin,
                 "drop tags of a lower decision margin")
      ->type_name("M")
      ->check(number_between(0, 255));
  app.add_option("--min-log-odds", arguments.detector.min_log_odds,
                 "drop tags of lower log-odds to be true")
      ->type_name("L")
      ->check(number_between(-1000, 1000));
  app.add_flag("--unusual-prints", arguments.unusual_prints, "report inverted and mirrored tags");
  app.add_flag("--no-photometric", arguments.no_photometric, "keep the corners of the border");
  app.add_flag("--no-refine", arguments.no_refine, "keep the edges as first found");
}

void add_output_options(CLI::App& app, DetectArguments& arguments) {
  app.add_option("--camera", arguments.camera, "for poses: focal lengths, centre; px")
      ->type_name("FX,FY,CX,CY");
  app.add_option("--distortion", arguments.distortion, "of the lens: K1,K2,P1,P2,K3")
      ->type_name("K1,...");
  app.add_option("--edge", arguments.edge, "side of the border square, like 40mm")
      ->type_name("LEN");
  add_choice(app, "--format", arguments.format, {"text", "jsonl", "csv"}, "text, jsonl or csv")
      ->type_name("FORM")
      ->default_str("by -o, else text");
  add_output(app, arguments.output);
  app.add_option("--overlay", arguments.overlay, "draw the tags: a PNG, {name}.png or a folder")
      ->type_name("FILE");
  app.add_option("--debug", arguments.debug, "write pictures of every step")->type_name("DIR");
  app.add_flag("--require", arguments.require, "exit 1 when some image has no tag");
  app.add_flag("--stats", arguments.stats, "counters and times on stderr");
}

Runner set_up(CLI::App& app, const Common& common) {
  auto arguments = std::make_shared<DetectArguments>();
  app.add_option("IMAGE", arguments->images, "PNG, JPEG, PNM or TIFF, or a folder; - is stdin")
      ->required();
  add_search_options(app, *arguments);
  add_output_options(app, *arguments);
  return [arguments, &common] { return run(*arguments, common); };
}

}  // namespace

Command detect_command() {
  return {.name = "detect",
          .summary = "find tags in images",
          .examples = {"tagmint detect --family tag36h11 photo.jpg --overlay found.png",
                       "tagmint detect --family tag36h11 --camera 600,600,320,240 --edge 40mm "
                       "*.png"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
