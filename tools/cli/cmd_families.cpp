#include "cli/cmd_families.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/family_text.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/text_table.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string format;
  std::string output;
};

std::string families_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& name : codec::family_names()) {
    list.push_back(family_summary_json(*codec::find_family(name)));
  }
  return nlohmann::ordered_json{{"families", list}}.dump(2) + "\n";
}

std::string families_text() {
  std::vector<std::vector<std::string>> rows = {
      {"name", "bits", "codes", "distance", "safe", "edge/outer", "layout", "levels"}};
  for (const std::string& name : codec::family_names()) {
    const codec::SharedFamily family = codec::find_family(name);
    const codec::Layout& layout = family->layout();
    // Ten rows of a custom layout would be wider than the table.
    const std::string layout_text = codec::layout_name(layout);
    rows.push_back(
        {name, fmt::to_string(family->bits()), fmt::to_string(family->size()),
         fmt::to_string(family->min_hamming()), fmt::to_string(family->max_safe_errors()),
         fmt::format("{}/{}", layout.width_at_border(), layout.width()),
         layout_text.starts_with("custom:") ? "custom" : layout_text, levels_text(*family)});
  }
  constexpr Align kLeft = Align::Left;
  constexpr Align kRight = Align::Right;
  return format_table({kLeft, kRight, kRight, kRight, kRight, kRight, kLeft, kLeft}, rows);
}

int run(const Options& options) {
  const std::vector<std::string> formats = {"text", "json"};
  const std::string format = choose_format(options.format, options.output, formats, "text");
  write_output(options.output, format == "json" ? families_json() : families_text());
  return kDone;
}

Runner set_up(CLI::App& app, const Common&) {
  auto options = std::make_shared<Options>();
  add_format(app, options->format, {"text", "json"}, "text");
  add_output(app, options->output);
  return [options] { return run(*options); };
}

}  // namespace

Command families_command() {
  return {.name = "families",
          .summary = "list the families that the program carries",
          .examples = {"tagmint families", "tagmint families --format json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
