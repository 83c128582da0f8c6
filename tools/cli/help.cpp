#include "cli/help.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

namespace tagmint::cli {
namespace {

constexpr const char* kCommonOptionsGroup = "Common options";
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

/// "-o,--output" or, for a positional, "FAMILY".
std::string option_name(const CLI::Option& option) {
  return option.get_positional() ? option.get_name(true, false) : option.get_name(false, true);
}

/// Options in a row of the help: those that follow each other with the same description.
struct HelpRow {
  const CLI::Option* first;
  std::vector<std::string> names;
  std::string type;  // of the last one
  std::string defaults;

  /// "--columns, --rows N"
  std::string left() const {
    const std::string all = fmt::format("{}", fmt::join(names, ", "));
    return type.empty() ? all : all + " " + type;
  }

  std::string description() const {
    std::string text = first->get_description();
    if (!defaults.empty()) text += fmt::format(" [default: {}]", defaults);
    if (first->get_required() && !first->get_positional()) text += " (required)";
    return text;
  }
};

/// Whether an option goes into the row before it: the same description, and values of one type.
bool joins(const CLI::Option& option, const HelpRow& row) {
  const std::string type = value_type(option);
  return row.first->get_description() == option.get_description() &&
         (row.type == type || row.type.empty() || type.empty());
}

std::vector<HelpRow> help_rows(const CLI::App& app) {
  std::vector<HelpRow> rows;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    const std::string value = shown_default(*option);
    const std::string type = value_type(*option);
    if (rows.empty() || !joins(*option, rows.back())) {
      rows.push_back({option, {option_name(*option)}, type, value});
      continue;
    }
    HelpRow& row = rows.back();
    // A flag after an option with a value: the value stays with its option.
    if (type.empty() && !row.type.empty()) {
      row.names.back() += " " + row.type;
      row.type.clear();
    } else {
      row.type = type;
    }
    row.names.push_back(option_name(*option));
    if (!value.empty()) row.defaults += (row.defaults.empty() ? "" : ", ") + value;
  }
  return rows;
}

}  // namespace

std::string value_type(const CLI::Option& option) {
  const bool takes_value = !option.get_positional() && option.get_items_expected_max() > 0;
  return takes_value ? type_name(option) : "";
}

std::string shown_default(const CLI::Option& option) {
  const std::string value = option.get_default_str();
  const bool shown =
      !option.get_required() && !value.empty() && value != "[]" && value != "{}" && value != "\"\"";
  return shown ? value : "";
}

std::string command_usage(const Command& command, const CLI::App& app) {
  std::string line = fmt::format("usage: tagmint {}", command.name);
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() || !option->get_required()) continue;
    const std::string type = value_type(*option);
    line += " " + option_name(*option) + (type.empty() ? "" : " " + type);
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

std::string command_about(const Command& command, const CLI::App& app) {
  return fmt::format("tagmint {}: {}. {}", command.name, command.summary, app.get_description());
}

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
  for (const std::string& line : wrapped(command_about(command, app), kColumns))
    text += line + "\n";
  text += "\n" + command_usage(command, app);
  std::string arguments, options, common, heading;
  for (const HelpRow& row : help_rows(app)) {
    const std::string& group = row.first->get_group();
    std::string& section = row.first->get_positional()    ? arguments
                           : group == kCommonOptionsGroup ? common
                                                          : options;
    if (&section == &options && group != heading) {
      heading = group;
      options += group + ":\n";
    }
    section += table_row(row.left(), row.description());
  }
  common += table_row("-h,--help", "this text");
  if (!arguments.empty()) text += "Arguments:\n" + arguments;
  if (!options.empty()) text += "\n" + options;
  text += "Common options:\n" + common + "\nExamples:\n";
  for (const std::string_view example : command.examples) text += fmt::format("  {}\n", example);
  return text;
}

}  // namespace tagmint::cli
