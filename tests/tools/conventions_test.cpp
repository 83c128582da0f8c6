// What every command shares: help, options, faults, exit codes, streams. Run from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "support/places.h"
#include "support/running_program.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/version.h"

namespace tagmint::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Runs a line of the shell in which $TAGMINT is the program.
ProgramResult shell(const std::string& line) {
  return RunningProgram({"/bin/sh", "-c", line}, Stderr::Pipe, {"TAGMINT=" + program_path()})
      .finish();
}

TEST(Conventions, ProgramHelpListsEveryCommandAndFitsAScreen) {
  const ProgramResult result = tagmint({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(tagmint({"-h"}).out, result.out);
  const std::vector<std::string> lines = lines_of(result.out);
  EXPECT_LE(lines.size(), 40U);
  for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
  for (const cli::Command& command : cli::command_table()) {
    const std::string row = "  " + std::string(command.name) + " ";
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with(row);
    })) << command.name;
  }
}

TEST(Conventions, HelpOfEachCommandFitsAScreenAndEndsWithTwoExamples) {
  for (const cli::Command& command : cli::command_table()) {
    const std::string name(command.name);
    SCOPED_TRACE(name);
    const ProgramResult result = tagmint({name, "--help"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    const std::vector<std::string> lines = lines_of(result.out);
    ASSERT_GE(lines.size(), 5U);
    EXPECT_LE(lines.size(), 40U);
    for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
    EXPECT_EQ(lines[lines.size() - 3], "Examples:");
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(lines[lines.size() - 2 + i], "  " + std::string(command.examples[i]));
      EXPECT_TRUE(command.examples[i].starts_with("tagmint " + name)) << command.examples[i];
    }
    for (const char* common : {"--threads", "--quiet", "--progress", "--help"}) {
      EXPECT_NE(result.out.find(common), std::string::npos) << common;
    }
  }
}

TEST(Conventions, HelpShowsDefaults) {
  const std::string help = tagmint({"generate", "--help"}).out;
  EXPECT_NE(help.find("[default: 1]"), std::string::npos) << help;
  EXPECT_NE(help.find("[default: lexicode]"), std::string::npos) << help;
}

TEST(Conventions, HelpIsGivenWhateverElseIsWrong) {
  EXPECT_EQ(tagmint({"generate", "--layuot", "--help"}).exit_code, 0);
}

TEST(Conventions, VersionIsThatOfTheLibrary) {
  const ProgramResult result = tagmint({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "tagmint " + std::string(codec::kVersion) + "\n");
}

TEST(Conventions, WrongCommandsGetASuggestion) {
  expect_fault({}, 2, "no command given; see 'tagmint --help'");
  expect_fault({"famlies"}, 2, "unknown command 'famlies'; did you mean 'families'?");
  expect_fault({"frobnicate"}, 2, "unknown command 'frobnicate'; see 'tagmint --help'");
  expect_fault({"--versoin"}, 2, "unknown option '--versoin'; did you mean '--version'?");
  expect_fault({"--frobnicate"}, 2,
               "unknown option '--frobnicate'; options follow the command; see 'tagmint --help'");
}

TEST(Conventions, WrongOptionsGetASuggestion) {
  expect_fault({"families", "--fromat", "json"}, 2,
               "unknown option '--fromat'; did you mean '--format'?");
  expect_fault({"families", "--fromat=json"}, 2,
               "unknown option '--fromat'; did you mean '--format'?");
  expect_fault({"families", "--frobnicate"}, 2,
               "unknown option '--frobnicate'; see 'tagmint families --help'");
  expect_fault({"generate", "--layuot", "classic:8"}, 2,
               "unknown option '--layuot'; did you mean '--layout'?");
  expect_fault({"families", "-x"}, 2, "unknown option '-x'; see 'tagmint families --help'");
}

TEST(Conventions, WrongValuesAreNamedWithTheirOption) {
  expect_fault({"families", "--format", "jsn"}, 2,
               "'jsn' is not possible (--format); did you mean 'json'? it is one of text, json");
  expect_fault({"families", "--progress=bar"}, 2,
               "'bar' is not possible (--progress); it is one of auto, always, never, json");
  expect_fault({"families", "--threads", "many"}, 2,
               "'many' is not a number from 0 to 1024 (--threads); see 'tagmint families --help'");
  expect_fault({"families", "--threads", "-1"}, 2,
               "'-1' is not a number from 0 to 1024 (--threads); see 'tagmint families --help'");
  expect_fault({"families", "--threads"}, 2,
               "the value is missing (--threads); see 'tagmint families --help'");
  expect_fault({"families", "--format", "json", "--format", "json"}, 2,
               "given too often (--format); see 'tagmint families --help'");
  expect_fault({"families", "tag36h11"}, 2,
               "too many arguments: tag36h11; see 'tagmint families --help'");
  expect_fault({"encode", "tag36h11"}, 2, "ID is missing; see 'tagmint encode --help'");
}

TEST(Conventions, OutputExtensionThatNamesNoFormatIsRefused) {
  expect_fault({"families", "-o", "families.xml"}, 2,
               "the extension '.xml' names no format of this command (families.xml); use one of "
               "text, json, or --format");
}

TEST(Conventions, ClosedStdoutIsAFaultAndNoOtherFileTakesItsPlace) {
  const ProgramResult result = shell("\"$TAGMINT\" encode tag16h5 0 >&-");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err,
            "tagmint: error: cannot write: Bad file descriptor (stdout); give the result another "
            "place with -o FILE\n");
}

TEST(Conventions, FullDiskIsAFault) {
  const ProgramResult result = shell("\"$TAGMINT\" families >/dev/full");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err,
            "tagmint: error: cannot write: No space left on device (stdout); give the result "
            "another place with -o FILE\n");
}

TEST(Conventions, ReaderThatLeavesIsNoCrashAndNoComplaint) {
  // The picture of all codes is far longer than a pipe holds.
  const ProgramResult result =
      shell("{ \"$TAGMINT\" encode tag36h11 0-; echo $? >&2; } | head -n 1");
  EXPECT_EQ(result.err, "4\n");
  EXPECT_EQ(lines_of(result.out).size(), 1U);
}

TEST(Conventions, ClosedStderrDoesNoHarm) {
  const ProgramResult result = shell("\"$TAGMINT\" famlies 2>&-");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
}

TEST(Conventions, ColourOnlyOnATerminalAndNotWithNoColor) {
  const auto on_terminal = [](const std::vector<std::string>& environment) {
    return RunningProgram(tagmint_words({"famlies"}), Stderr::Terminal, environment).finish().err;
  };
  EXPECT_NE(on_terminal({"TERM=xterm", "NO_COLOR="}).find("\033[1;31merror:\033[0m"),
            std::string::npos);
  EXPECT_EQ(on_terminal({"TERM=xterm", "NO_COLOR=1"}).find('\033'), std::string::npos);
  EXPECT_EQ(on_terminal({"TERM=dumb", "NO_COLOR="}).find('\033'), std::string::npos);
  EXPECT_EQ(tagmint({"famlies"}).err.find('\033'), std::string::npos);
}

}  // namespace
}  // namespace tagmint::test
