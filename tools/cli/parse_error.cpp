#include "cli/parse_error.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tagmint/codec/suggest.h"

namespace tagmint::cli {
namespace {

std::string see_help(std::string_view command) {
  return fmt::format("see 'tagmint {} --help'", command);
}

/// Long and short names of the options that the help lists, with their dashes.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names = {"--help"};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// "NAME: REST" split at its colon; the name is empty where there is none.
std::pair<std::string, std::string> split_name(const std::string& text) {
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos) return {"", text};
  return {text.substr(0, colon), text.substr(colon + 2)};
}

/// "Value 65 not in range 1 to 64", as CLI::Range says it, becomes "'65' is not a number from 1 to
/// 64"; other complaints stay.
std::string in_our_words(const std::string& complaint) {
  constexpr std::string_view kBegin = "Value ";
  constexpr std::string_view kMiddle = " not in range ";
  const std::size_t middle = complaint.find(kMiddle);
  if (!complaint.starts_with(kBegin) || middle == std::string::npos) return complaint;
  return fmt::format("'{}' is not a number from {}",
                     complaint.substr(kBegin.size(), middle - kBegin.size()),
                     complaint.substr(middle + kMiddle.size()));
}

}  // namespace

void throw_if_unknown_option(const CLI::App& app, std::string_view command) {
  for (const std::string& argument : app.remaining()) {
    if (argument.size() < 2 || argument[0] != '-' || argument == "--") continue;
    const std::string name = argument.substr(0, argument.find('='));
    const std::string hint = codec::did_you_mean(name, option_names(app));
    throw UsageError(fmt::format("unknown option '{}'", name), "",
                     hint.empty() ? see_help(command) : hint);
  }
}

UsageError usage_error(const CLI::ParseError& error, std::string_view command) {
  const std::string text = error.what();
  if (const auto* extras = dynamic_cast<const CLI::ExtrasError*>(&error)) {
    const auto [_, arguments] = split_name(extras->what());
    return UsageError(fmt::format("too many arguments: {}", arguments), "", see_help(command));
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    const std::string name = text.substr(0, text.find(' '));
    return UsageError(fmt::format("{} is missing", name), "", see_help(command));
  }
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    const auto [_, assignment] = split_name(text);  // "--threads = many"
    const std::size_t equals = assignment.find(" = ");
    if (equals != std::string::npos) {
      return UsageError(fmt::format("'{}' is not a number", assignment.substr(equals + 3)),
                        assignment.substr(0, equals), see_help(command));
    }
  }
  const auto [name, fault] = split_name(text);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const bool missing = fault.ends_with("missing");  // "1 required LAYOUT missing"
    return UsageError(missing ? "the value is missing" : "given too often", name,
                      see_help(command));
  }
  return UsageError(in_our_words(fault), name, see_help(command));
}

}  // namespace tagmint::cli
