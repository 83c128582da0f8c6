#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "tagmint/codec/family.h"

namespace CLI {
class Option;
}

namespace tagmint::cli {

/// What --progress takes, in the order of ProgressMode.
std::span<const std::string> progress_words();

/// Adds --threads, --quiet and --progress.
void add_common_options(CLI::App& app, Common& common);

/// Adds an option that takes one of a few words; another word is a usage error with the nearest
/// one. The words are shown as the option's type, "text|json", and `value` as its default.
///   names   as CLI11 has them, "--format"
CLI::Option* add_choice(CLI::App& app, const std::string& names, std::string& value,
                        std::vector<std::string> words, const std::string& description);

/// Adds `--format` with those words; `value` stays empty unless it is given, so that
/// choose_format() may look at the output's extension.
CLI::Option* add_format(CLI::App& app, std::string& value, std::vector<std::string> formats,
                        const std::string& fallback);

/// Adds `-o,--output FILE` with the default stdout.
CLI::Option* add_output(CLI::App& app, std::string& target,
                        const std::string& description = "write to FILE, - is stdout");

/// Adds the required positional FAMILY: a bundled name or a path; read it with
/// codec::load_family().
CLI::Option* add_family(CLI::App& app, std::string& name_or_path);

/// A check for an option's value: a finite number from `least` to `most`, named in the complaint.
std::function<std::string(const std::string&)> number_between(double least, double most);

/// Adds an option that is part of the contract but not of this version: it is not listed in the
/// help, and giving it is a usage error that says so.
void add_absent_option(CLI::App& app, const std::string& name, const std::string& instead);

/// Format of a result: the option's value where one was given, else the one that the target's
/// extension names ("out.JSONL" -> "jsonl"), else `fallback`.
///   formats   those that the command writes; an extension that is none of them is a usage error
/// Throws UsageError.
std::string choose_format(const std::string& option_value, const std::string& target,
                          std::span<const std::string> formats, const std::string& fallback);

/// Turns a library's complaint "WHAT; HOW TO MEND" about an argument into a usage error that names
/// the option.
UsageError usage_error(const std::invalid_argument& complaint, std::string_view option);

/// Calls parse(text), where a std::invalid_argument becomes a usage error that names the option.
template <typename Parse>
auto parse_option(Parse parse, std::string_view text, std::string_view option)
    -> decltype(parse(text)) {
  try {
    return parse(text);
  } catch (const std::invalid_argument& complaint) {
    throw usage_error(complaint, option);
  }
}

}  // namespace tagmint::cli
