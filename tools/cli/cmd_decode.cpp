#include "cli/cmd_decode.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/decoder_option.h"
#include "cli/options.h"
#include "cli/output.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"

namespace tagmint::cli {
namespace {

struct Options {
  std::string family;
  std::vector<std::string> codes;
  std::string format;
  std::string output;
  DecoderArguments decoding;
};

struct Reading {
  codec::Codeword observed = 0;
  std::optional<codec::Match> match;
};

codec::Codeword parse_codeword(const std::string& text, const codec::Family& family) {
  std::string_view digits = text;
  if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
  codec::Codeword word = 0;
  const char* end_of_digits = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), end_of_digits, word, 16);
  if (digits.empty() || end != end_of_digits || error == std::errc::invalid_argument) {
    throw UsageError(fmt::format("'{}' is not a codeword", text), "CODE",
                     "write hex digits, like 0xd7e00984b");
  }
  const int bits = family.bits();
  if (error == std::errc::result_out_of_range || (word & ~codec::low_mask(bits)) != 0) {
    throw UsageError(fmt::format("'{}' has more than {} bits", text, bits), "CODE",
                     fmt::format("give a codeword of {}", family.name()));
  }
  return word;
}

std::string readings_json(const codec::Decoder& decoder, const std::vector<Reading>& readings) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const Reading& reading : readings) {
    nlohmann::ordered_json result = {{"code", codec::to_hex(reading.observed)}, {"id", nullptr}};
    if (reading.match) {
      result["id"] = reading.match->id;
      result["hamming"] = reading.match->hamming;
      result["rotation"] = reading.match->rotation;
    }
    results.push_back(result);
  }
  const nlohmann::ordered_json all = {{"family", decoder.family()->name()},
                                      {"max_hamming", decoder.max_errors()},
                                      {"results", results}};
  return all.dump(2) + "\n";
}

std::string readings_text(const std::vector<Reading>& readings) {
  std::string text;
  for (const auto& [observed, match] : readings) {
    text += codec::to_hex(observed);
    text += match ? fmt::format(" id {} hamming {} rotation {}\n", match->id, match->hamming,
                                match->rotation)
                  : std::string(" no tag\n");
  }
  return text;
}

int run(const Options& options) {
  const std::vector<std::string> formats = {"text", "json"};
  const std::string format = choose_format(options.format, options.output, formats, "text");
  const codec::SharedFamily family = codec::load_family(options.family);
  std::vector<Reading> readings;
  for (const std::string& code : options.codes) {
    readings.push_back({parse_codeword(code, *family), std::nullopt});
  }
  const codec::Decoder decoder = make_decoder(family, options.decoding);
  for (Reading& reading : readings) reading.match = decoder.decode(reading.observed);
  write_output(options.output,
               format == "json" ? readings_json(decoder, readings) : readings_text(readings));
  const bool any = std::any_of(readings.begin(), readings.end(),
                               [](const Reading& reading) { return reading.match.has_value(); });
  return any ? kDone : kAnswerIsNo;
}

Runner set_up(CLI::App& app, const Common&) {
  app.description("Looks in all four rotations. Exit code 1 when no codeword matches.");
  auto options = std::make_shared<Options>();
  add_family(app, options->family);
  app.add_option("CODE", options->codes, "codewords in hex, the first data cell as highest bit")
      ->required();
  add_decoder_options(app, options->decoding);
  add_format(app, options->format, {"text", "json"}, "text");
  add_output(app, options->output);
  return [options] { return run(*options); };
}

}  // namespace

Command decode_command() {
  return {.name = "decode",
          .summary = "find the tag nearest to each codeword",
          .examples = {"tagmint decode tag36h11 0xd7e00984b",
                       "tagmint decode my.json 1f4ec0 --max-hamming 4 --format json"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
