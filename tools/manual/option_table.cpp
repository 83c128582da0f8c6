#include "manual/option_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/options.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::manual {
namespace {

/// "text|json" -> text, json; nothing where these are no words to be typed as they are.
std::vector<std::string> words_of(std::string_view type) {
  std::vector<std::string> words;
  while (type.find('|') != std::string_view::npos || !words.empty()) {
    const std::size_t end = std::min(type.find('|'), type.size());
    words.emplace_back(type.substr(0, end));
    if (end == type.size()) break;
    type.remove_prefix(end + 1);
  }
  const bool typed = std::none_of(words.begin(), words.end(), [](const std::string& word) {
    return std::any_of(word.begin(), word.end(), [](char c) { return 'A' <= c && c <= 'Z'; });
  });
  return typed ? words : std::vector<std::string>{};
}

/// Sets `offer` from the name of the value: FILE, FAMILY, text|json.
void set_offer(Entry& entry) {
  const std::string& type = entry.is_argument ? entry.names.front() : entry.value_type;
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), type) != names.end();
  };
  entry.words = words_of(type);
  if (type == "WHEN") {
    const auto words = cli::progress_words();
    entry.words.assign(words.begin(), words.end());
  }
  if (!entry.words.empty()) {
    entry.offer = Offer::Words;
  } else if (is_one_of({"FAMILY", "TAG", "IN"})) {
    entry.offer = Offer::Families;
  } else if (is_one_of({"FILE", "IMAGE", "INPUT", "SCENE"})) {
    entry.offer = Offer::Files;
  } else if (type == "DIR") {
    entry.offer = Offer::Folders;
  }
}

Entry entry_of(const CLI::Option& option) {
  Entry entry;
  entry.is_argument = option.get_positional();
  if (entry.is_argument) {
    entry.names = {option.get_name(true, false)};
  } else {
    for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  }
  entry.many = option.get_items_expected_max() > 1;
  entry.required = option.get_required();
  entry.value_type = cli::value_type(option);
  entry.description = option.get_description();
  entry.default_value = cli::shown_default(option);
  entry.group = option.get_group();
  set_offer(entry);
  return entry;
}

}  // namespace

std::vector<CommandEntry> option_table() {
  std::vector<CommandEntry> table;
  for (const cli::Command& command : cli::command_table()) {
    CLI::App app;
    app.set_help_flag();
    app.option_defaults()->always_capture_default();
    cli::Common common;
    const cli::Runner runner = command.set_up(app, common);  // keeps the options' variables alive
    cli::add_common_options(app, common);
    CommandEntry entry{.name = std::string(command.name),
                       .summary = std::string(command.summary),
                       .about = cli::command_about(command, app),
                       .usage = cli::command_usage(command, app),
                       .entries = {},
                       .examples = {command.examples.begin(), command.examples.end()}};
    entry.usage.erase(0, std::string_view("usage: ").size());
    entry.usage.erase(entry.usage.find_last_not_of('\n') + 1);
    for (const CLI::Option* option : app.get_options()) {
      if (!option->get_group().empty()) entry.entries.push_back(entry_of(*option));
    }
    Entry help;
    help.names = {"-h", "--help"};
    help.description = "a shorter form of this text";
    help.group = entry.entries.back().group;
    entry.entries.push_back(std::move(help));
    table.push_back(std::move(entry));
  }
  return table;
}

const Entry* offered_argument(const CommandEntry& command) {
  const auto found = std::find_if(
      command.entries.begin(), command.entries.end(),
      [](const Entry& entry) { return entry.is_argument && entry.offer != Offer::Nothing; });
  return found == command.entries.end() ? nullptr : &*found;
}

std::vector<std::string> family_words() {
  const auto names = codec::family_names();
  return {names.begin(), names.end()};
}

}  // namespace tagmint::manual
