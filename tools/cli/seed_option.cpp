#include "cli/seed_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>
#include <string_view>

#include "cli/command.h"

namespace tagmint::cli {
namespace {

std::uint64_t parse_seed(std::string_view text) {
  std::uint64_t seed = 0;
  const char* end_of_text = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), end_of_text, seed);
  if (error != std::errc() || end != end_of_text) {
    throw UsageError(fmt::format("'{}' is not a seed", text), "--seed",
                     "write a whole number from 0 to 18446744073709551615");
  }
  return seed;
}

}  // namespace

CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed) {
  return app
      .add_option_function<std::string>(
          "--seed", [&seed](const std::string& text) { seed = parse_seed(text); },
          "another seed, another scene")
      ->default_str(fmt::format("{}", seed))
      ->type_name("N");
}

}  // namespace tagmint::cli
