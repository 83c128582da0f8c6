#include <fmt/format.h>

#include "manual/writers.h"
#include "tagmint/codec/version.h"

namespace tagmint::manual {
namespace {

/// Text of ours as troff text: no control lines, no escapes; "-" is a minus, as options are typed.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (c == '\'') {
      out += "\\(aq";
    } else {
      out += c;
    }
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string header(std::string_view name) {
  std::string upper(name);
  for (char& c : upper) c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return fmt::format(".TH {} 1 \"\" \"tagmint {}\" \"tagmint\"\n.nh\n", escaped(upper),
                     codec::kVersion);
}

std::string entry_lines(const Entry& entry) {
  std::string head;
  for (const std::string& name : entry.names) {
    head += fmt::format("{}\\fB{}\\fR", head.empty() ? "" : ", ", escaped(name));
  }
  if (entry.takes_value()) head += fmt::format(" \\fI{}\\fR", escaped(entry.value_type));
  std::string text = entry.description;
  if (!entry.default_value.empty()) text += fmt::format(" [default: {}]", entry.default_value);
  if (entry.required && !entry.is_argument) text += " (required)";
  return fmt::format(".TP\n{}\n{}\n", head, escaped(text));
}

std::string example_lines(const std::vector<std::string>& examples) {
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (const std::string& example : examples) text += escaped(example) + "\n";
  return text + ".fi\n";
}

constexpr const char* kExitStatus =
    ".SH EXIT STATUS\n"
    "0 done; 1 the answer is no; 2 usage error; 3 bad input; 4 no output, or out of a resource;\n"
    "130 interrupted.\n";

}  // namespace

std::string program_page(std::span<const CommandEntry> table) {
  std::string text = header("tagmint");
  text +=
      ".SH NAME\ntagmint \\- make, print and find square fiducial tags (AprilTags)\n"
      ".SH SYNOPSIS\n\\fBtagmint\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fIARGUMENTS\\fR]\n"
      ".SH DESCRIPTION\nOne program, one subcommand a job. Each has a manual page of its own.\n"
      "\\fBtagmint \\-\\-version\\fR tells the version.\n.SH COMMANDS\n";
  for (const CommandEntry& command : table) {
    text +=
        fmt::format(".TP\n\\fB{}\\fR\n{}\n", escaped(command.name), escaped(command.summary + "."));
  }
  text += kExitStatus;
  text += ".SH SEE ALSO\n";
  for (const CommandEntry& command : table) {
    text += fmt::format("\\fBtagmint\\-{}\\fR(1){}\n", escaped(command.name),
                        &command == &table.back() ? "" : ",");
  }
  return text;
}

std::string command_page(const CommandEntry& command) {
  std::string text = header("tagmint-" + command.name);
  text += fmt::format(".SH NAME\ntagmint\\-{} \\- {}\n.SH SYNOPSIS\n{}\n", escaped(command.name),
                      escaped(command.summary), escaped(command.usage));
  text += fmt::format(".SH DESCRIPTION\n{}\n", escaped(command.about));
  std::string heading;
  for (const bool arguments : {true, false}) {
    for (const Entry& entry : command.entries) {
      if (entry.is_argument != arguments) continue;
      const std::string wanted = arguments ? "ARGUMENTS" : entry.group;
      if (wanted != heading) text += fmt::format(".SH \"{}\"\n", escaped(wanted));
      heading = wanted;
      text += entry_lines(entry);
    }
  }
  text += example_lines(command.examples);
  text += kExitStatus;
  return text + ".SH SEE ALSO\n\\fBtagmint\\fR(1)\n";
}

}  // namespace tagmint::manual
