#pragma once

#include <string>
#include <vector>

namespace tagmint::manual {

/// What a shell may offer for a value.
enum class Offer { Nothing, Words, Families, Files, Folders };

/// An option of a command, or a positional argument, as its command added it.
struct Entry {
  std::vector<std::string> names;  ///< "-o", "--output"; of an argument "FAMILY"
  bool is_argument = false;
  bool many = false;       ///< may come several times
  bool required = false;   ///< must come
  std::string value_type;  ///< "FILE"; empty for flags and arguments
  std::string description;
  std::string default_value;  ///< as the help shows it
  std::string group;          ///< its heading in the help
  Offer offer = Offer::Nothing;
  std::vector<std::string> words;  ///< where Offer::Words

  bool takes_value() const { return !value_type.empty(); }
};

/// A command with its options in the order of its help, `-h,--help` last.
struct CommandEntry {
  std::string name;
  std::string summary;  ///< one line
  std::string about;    ///< a paragraph, the summary included
  std::string usage;    ///< "tagmint detect [OPTIONS] IMAGE..."
  std::vector<Entry> entries;
  std::vector<std::string> examples;
};

/// All commands of the program, set up as if each had been called.
std::vector<CommandEntry> option_table();

/// What a shell may offer for the arguments of a command: that of the first one that has anything.
const Entry* offered_argument(const CommandEntry& command);

/// Names of the bundled families.
std::vector<std::string> family_words();

}  // namespace tagmint::manual
