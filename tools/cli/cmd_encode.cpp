#include "cli/cmd_encode.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/cell_picture.h"
#include "cli/id_list.h"
#include "cli/options.h"
#include "cli/output.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string family;
  std::vector<std::string> ids;
  std::string format;
  std::string output;
};

/// The ids of all arguments, in the order in which they were given.
std::vector<codec::TagId> ids_of(const Options& options, std::size_t family_size) {
  std::vector<codec::TagId> ids;
  for (const std::string& list : options.ids) {
    const std::vector<codec::TagId> part = parse_id_list(list, family_size, "ID");
    ids.insert(ids.end(), part.begin(), part.end());
  }
  return ids;
}

std::string tags_json(const codec::Family& family, const std::vector<codec::TagId>& ids) {
  nlohmann::ordered_json tags = nlohmann::ordered_json::array();
  for (const codec::TagId id : ids) {
    const codec::Codeword word = family.codeword(id);
    tags.push_back({{"id", id},
                    {"code", codec::to_hex(word)},
                    {"cells", codec::tag_cells(family.layout(), word).rows()}});
  }
  return nlohmann::ordered_json{{"family", family.name()}, {"tags", tags}}.dump(2) + "\n";
}

std::string tags_text(const codec::Family& family, const std::vector<codec::TagId>& ids) {
  std::string text;
  for (const codec::TagId id : ids) {
    const codec::Codeword word = family.codeword(id);
    text += fmt::format("{}{} id {}: {}\n", text.empty() ? "" : "\n", family.name(), id,
                        codec::to_hex(word));
    text += cell_picture(codec::tag_cells(family.layout(), word));
  }
  return text;
}

int run(const Options& options) {
  const std::vector<std::string> formats = {"text", "json"};
  const std::string format = choose_format(options.format, options.output, formats, "text");
  const codec::SharedFamily family = codec::load_family(options.family);
  const std::vector<codec::TagId> ids = ids_of(options, family->size());
  write_output(options.output,
               format == "json" ? tags_json(*family, ids) : tags_text(*family, ids));
  return kDone;
}

Runner set_up(CLI::App& app, const Common&) {
  app.description(
      "In the picture a block is a white cell, a blank is a black one, dots are no cell.");
  auto options = std::make_shared<Options>();
  add_family(app, options->family);
  app.add_option("ID", options->ids, "ids and ranges, like 7 or 0-9,12,20-")->required();
  add_format(app, options->format, {"text", "json"}, "text");
  add_output(app, options->output);
  return [options] { return run(*options); };
}

}  // namespace

Command encode_command() {
  return {.name = "encode",
          .summary = "show codewords and cell pictures of ids",
          .examples = {"tagmint encode tag36h11 7", "tagmint encode tag16h5 0-4 9 --format json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
