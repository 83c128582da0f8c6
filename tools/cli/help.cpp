#include "cli/help.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

namespace tagmint::cli {
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kTextColumn = 26;  // where descriptions start

/// `text` in lines of at most `width` characters, broken at spaces.
std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width)
      lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
    begin = end + 1;
  }
  return lines;
}

/// A line of a two-column table; a left part that is too wide has the first line for itself.
std::string table_row(std::string_view left, std::string_view right) {
  std::string row = fmt::format("  {}", left);
  if (row.size() + 2 > kTextColumn) row += '\n' + std::string(kTextColumn, ' ');
  if (row.size() < kTextColumn) row.append(kTextColumn - row.size(), ' ');
  std::string_view line_break = "";
  for (const std::string& line : wrapped(right, kColumns - kTextColumn)) {
    row += fmt::format("{}{:{}}{}", line_break, "", line_break.empty() ? 0 : kTextColumn, line);
    line_break = "\n";
  }
  return row + '\n';
}

/// The option's type as its command named it, "N": without what CLI11 appends for each check.
std::string type_name(const CLI::Option& option) {
  std::string type = option.get_type_name();
  for (const char* check : {":INT in [", ":FLOAT in [", ":NONNEGATIVE", ":POSITIVE"}) {
    type.erase(std::min(type.find(check), type.size()));
  }
  return type;
}

/// "-o,--output FILE" or, for a positional, "FAMILY".
std::string left_part(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true, false);
  std::string text = option.get_name(false, true);
  const std::string type = type_name(option);
  const bool takes_value = option.get_items_expected_max() > 0;
  if (takes_value && !type.empty()) text += " " + type;
  return text;
}

std::string description(const CLI::Option& option) {
  std::string text = option.get_description();
  const std::string value = option.get_default_str();
  const bool shown =
      !option.get_required() && !value.empty() && value != "[]" && value != "{}" && value != "\"\"";
  if (shown) text += fmt::format(" [default: {}]", value);
  if (option.get_required() && !option.get_positional()) text += " (required)";
  return text;
}

std::string usage_line(const Command& command, const CLI::App& app) {
  std::string line = fmt::format("usage: tagmint {}", command.name);
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() || !option->get_required()) continue;
    line += " " + left_part(*option);
  }
  line += " [OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    const bool many = option->get_items_expected_max() > 1;
    const std::string name = option->get_name(true, false) + (many ? "..." : "");
    line += option->get_required() ? " " + name : " [" + name + "]";
  }
  return line + "\n";
}

}  // namespace

std::string program_help(std::span<const Command> commands) {
  std::string text =
      "tagmint makes, prints and finds square fiducial tags (AprilTags).\n\n"
      "usage: tagmint COMMAND [OPTIONS] [ARGUMENTS]\n\nCommands:\n";
  for (const Command& command : commands) text += table_row(command.name, command.summary);
  text += "\nOptions:\n";
  text += table_row("-h,--help", "this text; after COMMAND: its options and examples");
  text += table_row("--version", "the program's version");
  text += "\nArguments:\n";
  text += table_row("FAMILY", "a bundled family (tag36h11) or a family file (my.json)");
  text += table_row("LAYOUT", "classic:W, standard:W, circle:W or custom:ROWS");
  text += table_row("LEN", "a length with its unit: 40mm, 4cm, 0.04m, 1.5in, 12pt");
  text += table_row("LIST", "ids and ranges: 0-9,12,20-");
  text += table_row("FILE", "a path; - is stdin or stdout");
  text +=
      "\nExit codes: 0 done, 1 the answer is no, 2 usage error, 3 bad input, 4 no output\n"
      "or out of a resource, 130 interrupted.\n\n"
      "Examples:\n  tagmint sheet tag36h11 --ids 0-9 --edge 40mm -o sheet.pdf\n  tagmint detect "
      "--family tag36h11 photo.png\n";
  return text;
}

std::string command_help(const Command& command, const CLI::App& app) {
  std::string text;
  const std::string about =
      fmt::format("tagmint {}: {}. {}", command.name, command.summary, app.get_description());
  for (const std::string& line : wrapped(about, kColumns)) text += line + "\n";
  text += "\n" + usage_line(command, app);
  std::string arguments, options, common;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    const bool shared = option->get_group() == "Common options";
    std::string& section = option->get_positional() ? arguments : shared ? common : options;
    section += table_row(left_part(*option), description(*option));
  }
  common += table_row("-h,--help", "this text");
  if (!arguments.empty()) text += "\nArguments:\n" + arguments;
  if (!options.empty()) text += "\nOptions:\n" + options;
  text += "\nCommon options:\n" + common + "\nExamples:\n";
  for (const std::string_view example : command.examples) text += fmt::format("  {}\n", example);
  return text;
}

}  // namespace tagmint::cli
