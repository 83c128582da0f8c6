#include "cli/decoder_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <utility>

#include "cli/id_list.h"
#include "cli/options.h"
#include "tagmint/codec/id_distance.h"

namespace tagmint::cli {
namespace {

/// "tag36h11 corrects", or "ids 0-59 of rot36 correct".
std::string who_corrects(const codec::Family& family, const std::string& ids) {
  constexpr std::size_t kLongestShown = 40;
  if (ids.empty()) return family.name() + " corrects";
  if (ids.size() > kLongestShown) return "the chosen ids of " + family.name() + " correct";
  return "ids " + ids + " of " + family.name() + " correct";
}

void require_safe_radius(const codec::Family& family, const codec::DecoderOptions& options,
                         const std::string& ids) {
  if (options.allow_unsafe_radius || !options.max_errors) return;
  const int distance = codec::distance_of_ids(family, options.ids);
  const int safe = (distance - 1) / 2;
  if (*options.max_errors <= safe) return;
  throw UsageError(fmt::format("{} bit errors are more than the {} that {} safely with distance {}",
                               *options.max_errors, safe, who_corrects(family, ids), distance),
                   "--max-hamming", fmt::format("ask for 0 to {}, or add --unsafe-radius", safe));
}

}  // namespace

void add_decoder_options(CLI::App& app, DecoderArguments& arguments) {
  app.add_option("--ids", arguments.ids, "ids to look for, like 0-9,12,20-")
      ->type_name("LIST")
      ->default_str("all");
  app.add_option("--max-hamming", arguments.max_hamming, "bit errors to correct")
      ->type_name("N")
      ->check(CLI::Range(0, codec::kMaxBits))
      ->default_str("min(2, safe)");
  app.add_flag("--unsafe-radius", arguments.unsafe_radius, "allow more than the ids' safe radius");
}

codec::Decoder make_decoder(const codec::SharedFamily& family, const DecoderArguments& arguments) {
  codec::DecoderOptions options;
  options.max_errors = arguments.max_hamming;
  options.allow_unsafe_radius = arguments.unsafe_radius;
  if (!arguments.ids.empty()) options.ids = parse_id_list(arguments.ids, family->size());
  require_safe_radius(*family, options, arguments.ids);
  try {
    return codec::Decoder(family, std::move(options));
  } catch (const std::invalid_argument& complaint) {
    throw usage_error(complaint, "--max-hamming");
  }
}

}  // namespace tagmint::cli
