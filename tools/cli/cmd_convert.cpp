#include "cli/cmd_convert.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/family_input.h"
#include "cli/number.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/terminal.h"
#include "io/atomic_folder.h"
#include "io/family_kinds/family_kind.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string input;
  std::string output;
  std::string to;
  std::string from;
  std::string codes;
  std::string name;
  std::string layout;
  std::optional<int> min_hamming;
  std::string opencv;
  std::string bit_order;
};

const io::FamilyKind& kind_to_write(const Options& options) {
  const io::FamilyKind* kind = options.to.empty() ? io::family_kind_of_output(options.output)
                                                  : io::find_family_kind(options.to);
  if (is_stdout(options.output) && options.to.empty()) kind = nullptr;
  if (!kind) {
    throw UsageError(
        "the name of the output does not tell its kind", options.output,
        fmt::format("name it with --to, one of {}", fmt::join(io::family_kind_names(), ", ")));
  }
  if (is_stdout(options.output) && !kind->one_file) {
    throw UsageError(fmt::format("{} is more than one file", kind->name), "-o",
                     "give it a name of its own");
  }
  return *kind;
}

void require_output(const io::FamilyKind& kind, const std::string& target) {
  if (kind.is_folder) {
    io::AtomicFolder::require_possible(target);
  } else {
    require_writable(target);
  }
}

io::FamilyReadOptions read_options(const Options& options, const Common& common) {
  io::FamilyReadOptions read{
      .name = options.name, .min_hamming = options.min_hamming, .threads = common.threads};
  if (!options.layout.empty()) {
    read.layout = parse_option(codec::parse_layout, options.layout, "--layout");
  }
  if (!options.opencv.empty()) {
    read.opencv = options.opencv == "4" ? io::OpenCvTurn::HalfTurned : io::OpenCvTurn::Upright;
  }
  if (options.bit_order == "rows") read.bit_order = io::BitOrder::Rows;
  if (options.bit_order == "quarter-blocks") read.bit_order = io::BitOrder::QuarterBlocks;
  return read;
}

/// The family as it goes into the kind: with its codewords listed unless the kind holds generators,
/// and cut where the user or the kind wants fewer tags, which is said.
codec::Family fitted(codec::Family family, const io::FamilyKind& kind, const Options& options,
                     const Common& common) {
  const std::size_t size = family.size();
  const std::size_t wanted = options.codes.empty()
                                 ? size
                                 : static_cast<std::size_t>(parse_count(options.codes, "--codes"));
  if (wanted > size) {
    throw UsageError(fmt::format("{} has {} codes, not {}", family.name(), size, wanted), "--codes",
                     "ask for fewer");
  }
  const std::size_t fitting = kind.most_codes == 0 ? wanted : std::min(wanted, kind.most_codes);
  if (fitting == size) {
    const bool as_it_is = family.is_listed() || kind.holds_generators;
    return as_it_is ? std::move(family) : codec::first_tags(family, size);
  }
  codec::Family part = codec::first_tags(family, fitting);
  const std::string reason =
      fitting < wanted ? fmt::format("{}", kind.limit_reason) : "--codes asks for no more";
  say(common,
      fmt::format("{}: only the first {} of {} codes are written, at distance {}; {} are "
                  "left out: {}",
                  family.name(), fitting, size, part.min_hamming(), size - fitting, reason));
  return part;
}

std::string written_names(const io::FamilyKind& kind, const std::string& target,
                          const std::vector<io::FamilyFile>& files) {
  if (kind.is_folder) return fmt::format("{}, {} files", target, files.size());
  std::vector<std::string> names;
  for (const io::FamilyFile& file : files) names.push_back(file.path);
  return fmt::format("{}", fmt::join(names, " and "));
}

int run(const Options& options, const Common& common) {
  const io::FamilyKind& kind = kind_to_write(options);
  if (!is_stdout(options.output)) require_output(kind, options.output);
  const InputFamily input =
      read_input_family(options.input, read_options(options, common), options.from);
  for (const std::string& note : input.notes) {
    say(common, fmt::format("{}: {}", input.family->name(), note));
  }
  const std::size_t size = input.family->size();
  const codec::Family family = fitted(*input.family, kind, options, common);
  io::FamilyWriteOptions write;
  if (options.opencv == "5") write.opencv = io::OpenCvTurn::Upright;
  if (family.size() < size) write.codes_before_cut = size;
  const std::vector<io::FamilyFile> files = kind.make(family, options.output, write);
  if (is_stdout(options.output)) {
    write_output(options.output, files.front().content);
    return kDone;
  }
  io::write_family_files(kind, options.output, files);
  const std::string turn =
      kind.name != "opencv" ? ""
      : write.opencv == io::OpenCvTurn::HalfTurned
          ? ", turned by 180 degrees as OpenCV 4's own AprilTag dictionaries are"
          : ", upright";
  say(common, fmt::format("{}: {} codes as {}{}; written to {}", family.name(), family.size(),
                          kind.name, turn, written_names(kind, options.output, files)));
  return kDone;
}

Runner set_up(CLI::App& app, const Common& common) {
  app.description(
      "Kinds: tagmint (.json), apriltag-c (.c and .h), opencv (.yml, .yaml, .json.gz, ...), png (a "
      "folder), rmsalinas (.txt, .dict), csv. IN's kind is seen from its content. Older systems: "
      "aruco-original, artoolkitplus-bch, artag, ... (docs/convert.md).");
  auto options = std::make_shared<Options>();
  Options& o = *options;
  app.add_option("IN", o.input, "bundled family, file, folder or older system; - is stdin")
      ->required();
  add_output(app, o.output, "file or folder to write")->required()->default_str("");
  add_choice(app, "--to", o.to, io::family_kind_names(), "kind of OUT; else by its extension")
      ->type_name("KIND");
  add_choice(app, "--from", o.from, io::family_kind_names(), "kind of IN; else by its content")
      ->type_name("KIND");
  app.add_option("--codes", o.codes, "write the first N only")
      ->type_name("N")
      ->default_str("all that the kind holds");
  app.add_option("--name", o.name, "name of the family; else as IN says, or IN's own")
      ->type_name("N");
  app.add_option("--layout", o.layout, "layout, where IN leaves it open")->type_name("LAYOUT");
  app.add_option("--min-hamming", o.min_hamming, "distance, where IN leaves it open")
      ->type_name("H")
      ->check(CLI::Range(1, codec::kMaxBits))
      ->default_str("computed");
  add_choice(app, "--opencv", o.opencv, {"4", "5"},
             "whose AprilTag dictionaries opencv files are like: 4 has tags turned by 180 degrees")
      ->default_str("OUT 4, IN as it says");
  add_choice(app, "--bit-order", o.bit_order, {"rows", "quarter-blocks"},
             "of a C table without places of bits")
      ->default_str("rows");
  return [options, &common] { return run(*options, common); };
}

}  // namespace

Command convert_command() {
  return {.name = "convert",
          .summary = "between family files, as libapriltag and OpenCV have them",
          .examples = {"tagmint convert my.json -o tagMy.c",
                       "tagmint convert tag36h11 --opencv 5 -o tag36h11.yml"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
