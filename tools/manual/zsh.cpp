#include <fmt/format.h>

#include "manual/writers.h"

namespace tagmint::manual {
namespace {

/// Text inside '...[text]:...' of _arguments: quotes and its special characters escaped.
std::string quoted(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string action(const Entry& entry) {
  switch (entry.offer) {
    case Offer::Words:
      return fmt::format("({})", fmt::join(entry.words, " "));
    case Offer::Families:
      return "_tagmint_families";
    case Offer::Files:
      return "_files";
    case Offer::Folders:
      return "_files -/";
    case Offer::Nothing:
      break;
  }
  return " ";
}

std::string option_specs(const Entry& entry) {
  std::string specs;
  for (const std::string& name : entry.names) {
    specs += fmt::format(
        " \\\n        '*{}[{}]{}'", name, quoted(entry.description),
        entry.takes_value() ? fmt::format(":{}:{}", quoted(entry.value_type), action(entry)) : "");
  }
  return specs;
}

}  // namespace

std::string zsh_completion(std::span<const CommandEntry> table) {
  std::string text = fmt::format(
      "#compdef tagmint\n_tagmint_families() {{\n  compadd -- {}\n  _files\n}}\n"
      "_tagmint() {{\n  local -a commands=(\n",
      fmt::join(family_words(), " "));
  for (const CommandEntry& command : table) {
    text += fmt::format("    '{}:{}'\n", command.name, quoted(command.summary));
  }
  text +=
      "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n"
      "  shift words\n  ((CURRENT--))\n  case $words[1] in\n";
  for (const CommandEntry& command : table) {
    text += fmt::format("    {})\n      _arguments", command.name);
    for (const Entry& entry : command.entries) {
      if (!entry.is_argument) text += option_specs(entry);
    }
    if (const Entry* argument = offered_argument(command)) {
      text +=
          fmt::format(" \\\n        '*:{}:{}'", quoted(argument->names.front()), action(*argument));
    }
    text += "\n      ;;\n";
  }
  return text + "  esac\n}\n_tagmint \"$@\"\n";
}

}  // namespace tagmint::manual
