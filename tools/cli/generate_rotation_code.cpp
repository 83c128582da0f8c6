#include "cli/generate_rotation_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cli/number.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/process.h"
#include "cli/progress.h"
#include "cli/terminal.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/search/order.h"
#include "tagmint/codec/search/rotation_codes.h"
#include "tagmint/codec/search/size_bound.h"

namespace tagmint::cli {
namespace {

std::vector<int> parse_levels(const std::string& text) {
  std::vector<int> levels;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto level = parse_count(text.substr(begin, end - begin), "--levels");
    levels.push_back(static_cast<int>(std::min<std::uint64_t>(level, codec::kMaxBits + 1)));
    begin = end + 1;
  }
  return levels;
}

std::uint64_t parse_seed(const std::string& order) {
  if (order.empty()) return 0;
  const codec::Order parsed = parse_option(codec::parse_order, order, "--order");
  if (parsed.kind != codec::Order::Kind::Seed) {
    throw UsageError(
        fmt::format("the order {} is for lexicodes; a rotation code has no walk", order), "--order",
        "give seed:N, or leave it out");
  }
  return static_cast<std::uint64_t>(parsed.seed);
}

codec::RotationCodeOptions plan(const RotationCodeRequest& request, const Common& common) {
  codec::RotationCodeOptions options{.layout = request.layout,
                                     .min_hamming = request.min_hamming,
                                     .levels = parse_levels(request.levels),
                                     .complexity = {codec::ComplexityRule::Energy, 0.3333},
                                     .seed = parse_seed(request.order),
                                     .attempts = request.attempts,
                                     .threads = common.threads};
  if (!request.complexity.empty()) {
    options.complexity = parse_option(codec::parse_complexity, request.complexity, "--complexity");
  }
  return options;
}

codec::RotationCodeResult search(codec::RotationCodeOptions options, const Common& common) {
  const InterruptGuard guard;
  Progress progress(common, "search", "tries");
  options.stop = guard.token();
  options.progress = [&](const codec::RotationCodeProgress& state) {
    progress.update(
        static_cast<double>(state.tries_done), static_cast<double>(state.tries),
        state.tags > 0 ? fmt::format("{}, {:.0f} codes", state.step, state.tags) : state.step);
  };
  try {
    codec::RotationCodeResult result = codec::search_rotation_code(options);
    progress.clear();
    if (result.stopped) guard.throw_if_interrupted("nothing was written");
    return result;
  } catch (const std::invalid_argument& complaint) {
    throw usage_error(complaint, "--levels");
  }
}

void tell_levels(const codec::Family& family, const Common& common) {
  std::size_t plain = 0;
  for (const codec::Level& level : family.levels()) {
    plain += level.plain;
    const std::string passed = family.complexity().rule == codec::ComplexityRule::None
                                   ? std::string()
                                   : fmt::format("; {} pass {}", level.codes - plain,
                                                 codec::to_string(family.complexity()));
    say(common, fmt::format("ids 0-{}: distance {}{}", level.codes - 1, level.min_hamming, passed));
  }
  if (plain > 0) say(common, "in each level the plain codes are the last ones");
}

}  // namespace

int generate_rotation_code(const RotationCodeRequest& request, const Common& common) {
  const codec::RotationCodeOptions options = plan(request, common);
  std::size_t enough = 0;
  if (!request.codes.empty()) {
    enough = static_cast<std::size_t>(parse_count(request.codes, "--codes"));
  }
  codec::RotationCodeResult result = search(options, common);
  if (!result.found()) {
    print_error(
        "no code closed under quarter turns was found (--layout, --min-hamming); ask for a smaller "
        "distance, or try --method lexicode");
    return kAnswerIsNo;
  }
  const std::string construction = result.construction;
  codec::Family family = codec::make_family(std::move(result), request.name);
  const std::size_t found = family.size();
  if (enough > 0 && enough < found) family = codec::first_tags(family, enough);
  write_output(request.output, codec::format_family(family));
  say(common, fmt::format("{}: {} codes by {}{}", family.name(), family.size(), construction,
                          is_stdout(request.output) ? "" : "; written to " + request.output));
  if (family.size() < found) say(common, fmt::format("the first of {} (--codes)", found));
  tell_levels(family, common);
  const codec::SizeBound bound = codec::upper_bound_of_tags(family.bits(), family.min_hamming());
  say(common, fmt::format("no family of {} bits at distance {} has more than {:.0f} codes ({})",
                          family.bits(), family.min_hamming(), bound.tags, bound.source));
  return kDone;
}

}  // namespace tagmint::cli
