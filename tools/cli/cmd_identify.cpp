#include "cli/cmd_identify.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/family_input.h"
#include "cli/identify_report.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/terminal.h"
#include "identify/identify.h"
#include "io/family_kinds/older_systems.h"
#include "io/images.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

using codec::SharedFamily;

struct Options {
  std::string image;
  std::vector<std::string> families;
  bool only = false;
  std::string format;
  std::string output;
};

SharedFamily shared(codec::Family family) {
  return std::make_shared<const codec::Family>(std::move(family));
}

/// Every family that the program knows by itself.
std::vector<SharedFamily> known_families() {
  std::vector<SharedFamily> families;
  for (const std::string& name : codec::family_names()) {
    families.push_back(codec::find_family(name));
  }
  for (const std::string& name : io::older_system_names()) {
    families.push_back(shared(io::find_older_system(name, {})->family));
  }
  return families;
}

SharedFamily family_of(const std::string& name, const Common& common) {
  InputFamily input = read_input_family(name, {.threads = common.threads}, "");
  for (const std::string& note : input.notes) say(common, name + ": " + note);
  return std::move(input.family);
}

/// The families to look for, one of each name; the user's own come first.
std::vector<SharedFamily> families_of(const Options& options, const Common& common) {
  if (options.only && options.families.empty()) {
    throw UsageError("there is no family to look for", "--only", "add --family FAMILY");
  }
  std::vector<SharedFamily> families;
  for (const std::string& name : options.families) {
    SharedFamily family = family_of(name, common);
    const bool twice =
        std::any_of(families.begin(), families.end(),
                    [&](const SharedFamily& known) { return known->name() == family->name(); });
    if (twice) {
      throw UsageError("the family " + family->name() + " is given twice", "--family",
                       "give each once");
    }
    families.push_back(std::move(family));
  }
  if (options.only) return families;
  const auto given = static_cast<std::ptrdiff_t>(families.size());
  for (SharedFamily& known : known_families()) {
    const bool replaced =
        std::any_of(families.begin(), families.begin() + given,
                    [&](const SharedFamily& own) { return own->name() == known->name(); });
    if (!replaced) families.push_back(std::move(known));
  }
  return families;
}

int run(const Options& options, const Common& common) {
  const std::vector<std::string> formats = {"text", "json"};
  const std::string format = choose_format(options.format, options.output, formats, "text");
  const std::vector<SharedFamily> families = families_of(options, common);
  const detect::Image picture = io::read_gray_image(options.image);
  IdentifyReport report{
      .image = options.image, .width = picture.width(), .height = picture.height(), .found = {}};
  report.found = identify::Identifier(families, common.threads).identify(picture);
  write_output(options.output, format == "json" ? identify_json(report) : identify_text(report));
  return report.found.tags.empty() ? kAnswerIsNo : kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "Says which tag it is, whether mirrored, turned, inverted or cut, and how sure that is; else "
      "the nearest miss, with exit code 1.");
  auto options = std::make_shared<Options>();
  app.add_option("IMAGE", options->image, "PNG, JPEG, PNM or TIFF; - is stdin")->required();
  app.add_option("--family", options->families,
                 "a family to look for too, in a file of any kind; give it again for more")
      ->type_name("FAMILY")
      ->allow_extra_args(false);
  app.add_flag("--only", options->only, "look for the families given alone");
  add_format(app, options->format, {"text", "json"}, "text");
  add_output(app, options->output);
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command identify_command() {
  return {.name = "identify",
          .summary = "which tag is this picture, and what became of it",
          .examples = {"tagmint identify photo.jpg",
                       "tagmint identify scan.png --family my.json --only --format json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
