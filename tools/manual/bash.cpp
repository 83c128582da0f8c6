#include <fmt/format.h>

#include "manual/writers.h"

namespace tagmint::manual {
namespace {

/// The command of the script that fills in what is offered for an entry.
std::string offer_line(const Entry& entry) {
  switch (entry.offer) {
    case Offer::Words:
      return fmt::format("_tagmint_words '{}'", fmt::join(entry.words, " "));
    case Offer::Families:
      return "_tagmint_families";
    case Offer::Files:
      return "_tagmint_files -f";
    case Offer::Folders:
      return "_tagmint_files -d";
    case Offer::Nothing:
      break;
  }
  return ":";
}

std::string command_case(const CommandEntry& command) {
  std::string values, options;
  for (const Entry& entry : command.entries) {
    if (entry.is_argument) continue;
    for (const std::string& name : entry.names) options += (options.empty() ? "" : " ") + name;
    if (entry.takes_value()) {
      values += fmt::format("        {}) {}; return ;;\n", fmt::join(entry.names, "|"),
                            offer_line(entry));
    }
  }
  const Entry* argument = offered_argument(command);
  return fmt::format(
      "    {})\n      case $previous in\n{}      esac\n      if [[ $current == -* ]]; then\n"
      "        _tagmint_words '{}'\n      else\n        {}\n      fi\n      ;;\n",
      command.name, values, options, argument ? offer_line(*argument) : ":");
}

}  // namespace

std::string bash_completion(std::span<const CommandEntry> table) {
  std::string names, cases;
  for (const CommandEntry& command : table) {
    names += command.name + " ";
    cases += command_case(command);
  }
  return fmt::format(
      "# bash completion for tagmint\n"
      "_tagmint_words() {{ mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$current\"); }}\n"
      "_tagmint_files() {{\n"
      "  compopt -o filenames 2>/dev/null\n"
      "  mapfile -t COMPREPLY < <(compgen \"$1\" -- \"$current\")\n}}\n"
      "_tagmint_families() {{\n"
      "  compopt -o filenames 2>/dev/null\n"
      "  mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$current\"; compgen -f -- \"$current\")\n"
      "}}\n"
      "_tagmint() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}}\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n    _tagmint_words '{}--help --version'\n    return\n  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}  esac\n}}\n"
      "complete -F _tagmint tagmint\n",
      fmt::join(family_words(), " "), names, cases);
}

}  // namespace tagmint::manual
