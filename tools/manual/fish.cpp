#include <fmt/format.h>

#include "manual/writers.h"

namespace tagmint::manual {
namespace {

std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

/// The arguments of `complete` for what is offered; files are offered only where -F says so.
std::string offer_arguments(const Entry& entry) {
  switch (entry.offer) {
    case Offer::Words:
      return fmt::format(" -a {}", quoted(fmt::format("{}", fmt::join(entry.words, " "))));
    case Offer::Families:
      return " -F -a \"$tagmint_families\"";
    case Offer::Files:
      return " -F";
    case Offer::Folders:
      return " -a '(__fish_complete_directories)'";
    case Offer::Nothing:
      break;
  }
  return "";
}

}  // namespace

std::string fish_completion(std::span<const CommandEntry> table) {
  std::string text = fmt::format(
      "# fish completion for tagmint\nset -l tagmint_families '{}'\ncomplete -c tagmint -f\n",
      fmt::join(family_words(), " "));
  const auto add = [&](std::string_view line) {
    text += fmt::format("complete -c tagmint {}\n", line);
  };
  for (const char* option : {"help", "version"}) {
    add(fmt::format("-n __fish_use_subcommand -l {}", option));
  }
  for (const CommandEntry& command : table) {
    add(fmt::format("-n __fish_use_subcommand -a {} -d {}", command.name, quoted(command.summary)));
    const std::string here = fmt::format("-n '__fish_seen_subcommand_from {}'", command.name);
    for (const Entry& entry : command.entries) {
      if (entry.is_argument) continue;
      std::string line = here;
      for (const std::string& name : entry.names) {
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      const bool files = entry.offer == Offer::Files || entry.offer == Offer::Families;
      if (entry.takes_value()) line += (files ? " -r" : " -x") + offer_arguments(entry);
      add(fmt::format("{} -d {}", line, quoted(entry.description)));
    }
    if (const Entry* argument = offered_argument(command)) add(here + offer_arguments(*argument));
  }
  return text;
}

}  // namespace tagmint::manual
