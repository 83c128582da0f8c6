#include "cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>

#include "cli/number.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::cli {
namespace {

constexpr int kMostThreads = 1024;

/// What a usage error about a word outside a list says.
UsageError not_in_list(std::string_view word, std::string_view option,
                       std::span<const std::string> words) {
  const std::string hint = codec::did_you_mean(word, words);
  return UsageError(
      fmt::format("'{}' is not possible", word), option,
      fmt::format("{}{}it is one of {}", hint, hint.empty() ? "" : " ", fmt::join(words, ", ")));
}

}  // namespace

std::span<const std::string> progress_words() {
  static const std::vector<std::string> words = {"auto", "always", "never", "json"};
  return words;
}

void add_common_options(CLI::App& app, Common& common) {
  app.add_option("--threads", common.threads, "number of threads; 0 = all cores")
      ->type_name("N")
      ->check(CLI::Range(0, kMostThreads))
      ->group("Common options");
  app.add_flag("--quiet", common.quiet, "no messages and no progress on stderr")
      ->group("Common options");
  app.add_option_function<std::string>(
         "--progress",
         [&common](const std::string& word) {
           const std::span<const std::string> words = progress_words();
           const auto place = std::find(words.begin(), words.end(), word);
           if (place == words.end()) throw not_in_list(word, "--progress", words);
           common.progress = static_cast<ProgressMode>(place - words.begin());
         },
         "auto (a bar on a terminal), always, never or json")
      ->type_name("WHEN")
      ->group("Common options");
}

CLI::Option* add_choice(CLI::App& app, const std::string& names, std::string& value,
                        std::vector<std::string> words, const std::string& description) {
  CLI::Option* option = app.add_option(names, value, description);
  option->type_name(fmt::format("{}", fmt::join(words, "|")));
  option->check([words = std::move(words), name = option->get_name()](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) {
      throw not_in_list(word, name, words);
    }
    return std::string();
  });
  return option;
}

CLI::Option* add_format(CLI::App& app, std::string& value, std::vector<std::string> formats,
                        const std::string& fallback) {
  return add_choice(app, "--format", value, std::move(formats),
                    "format of the result; else as the extension of FILE says")
      ->default_str(fallback);
}

CLI::Option* add_output(CLI::App& app, std::string& target, const std::string& description) {
  return app.add_option("-o,--output", target, description)->type_name("FILE")->default_str("-");
}

CLI::Option* add_family(CLI::App& app, std::string& name_or_path) {
  return app.add_option("FAMILY", name_or_path, "name of a bundled family, or a family file")
      ->required();
}

std::function<std::string(const std::string&)> number_between(double least, double most) {
  return [least, most](const std::string& text) {
    const auto number = leading_number(text);
    if (number && number->rest.empty() && number->value >= least && number->value <= most) {
      return std::string();
    }
    return fmt::format("'{}' is not a number from {} to {}", text, least, most);
  };
}

void add_absent_option(CLI::App& app, const std::string& name, const std::string& instead) {
  // A flag and an option with a value alike: the value is not looked at.
  const auto refuse = [name, instead](const CLI::results_t&) -> bool {
    throw UsageError(fmt::format("{} is not part of this version", name), "", instead);
  };
  app.add_option(name, CLI::callback_t(refuse))->expected(0, 1)->group("");
}

std::string choose_format(const std::string& option_value, const std::string& target,
                          std::span<const std::string> formats, const std::string& fallback) {
  if (!option_value.empty()) {
    if (std::find(formats.begin(), formats.end(), option_value) != formats.end()) {
      return option_value;
    }
    throw not_in_list(option_value, "--format", formats);
  }
  std::string extension = std::filesystem::path(target).extension().string();
  if (extension.empty()) return fallback;
  extension.erase(0, 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (std::find(formats.begin(), formats.end(), extension) != formats.end()) return extension;
  throw UsageError(fmt::format("the extension '.{}' names no format of this command", extension),
                   target, fmt::format("use one of {}, or --format", fmt::join(formats, ", ")));
}

UsageError usage_error(const std::invalid_argument& complaint, std::string_view option) {
  const std::string_view text = complaint.what();
  const std::size_t split = text.find("; ");
  if (split == std::string_view::npos) return UsageError(text, option, "");
  return UsageError(text.substr(0, split), option, text.substr(split + 2));
}

}  // namespace tagmint::cli
