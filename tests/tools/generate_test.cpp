#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

/// `generate` with a quick search of the classic 4x4 layout, and more words.
std::vector<std::string> quick(const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"generate", "--layout", "classic:8", "--min-hamming", "5"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A search that would run for hours.
std::vector<std::string> endless(const std::string& output) {
  return {"generate", "--layout", "classic:10", "--min-hamming",
          "11",       "-o",       output,       "--progress=json"};
}

codec::Family parsed(const ProgramResult& result) {
  return codec::parse_family(result.out, "stdout");
}

TEST(Generate, DefaultsForAClassicLayoutRemakeThePublishedFamily) {
  const ProgramResult result = tagmint(quick());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "tagmint: tag16h5: 30 codes, order apriltag2, all 2^16 words searched\n");
  const codec::Family family = parsed(result);
  const codec::SharedFamily published = codec::find_family("tag16h5");
  EXPECT_EQ(family.name(), "tag16h5");
  EXPECT_EQ(codec::family_digest(family), codec::family_digest(*published));
  EXPECT_EQ(family.complexity(), published->complexity());
}

TEST(Generate, DefaultsForTheOtherLayoutsRemakeThePublishedFamily) {
  const ProgramResult result = tagmint({"generate", "--layout", "circle:9", "--min-hamming", "7"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(codec::family_digest(parsed(result)),
            codec::family_digest(*codec::find_family("tagCircle21h7")));
}

TEST(Generate, ResultDoesNotDependOnTheNumberOfThreads) {
  const std::string one = tagmint(quick({"--order", "seed:5", "--threads", "1"})).out;
  EXPECT_EQ(tagmint(quick({"--order", "seed:5", "--threads", "2"})).out, one);
  EXPECT_EQ(tagmint(quick({"--order", "seed:5", "--threads", "7"})).out, one);
}

TEST(Generate, FileIsTheSameAsStdoutAndNothingElseIsLeft) {
  const ScratchFolder folder;
  const std::string file = folder.file("my.json");
  const ProgramResult result = tagmint(quick({"-o", file}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(read_file(file), tagmint(quick()).out);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"my.json"});
}

TEST(Generate, QuietSaysNothing) { EXPECT_EQ(tagmint(quick({"--quiet"})).err, ""); }

TEST(Generate, LimitsEndTheSearchAndAreRecorded) {
  const ProgramResult by_codes = tagmint(quick({"--limit-codes", "7"}));
  EXPECT_EQ(parsed(by_codes).size(), 7U);
  EXPECT_NE(parsed(by_codes).origin().searched, "complete");
  EXPECT_NE(by_codes.err.find("(--limit-codes)"), std::string::npos) << by_codes.err;
  const ProgramResult by_words = tagmint(quick({"--limit-words", "1e3"}));
  EXPECT_EQ(by_words.exit_code, 0);
  EXPECT_NE(by_words.err.find("after 1000 words (--limit-words)"), std::string::npos)
      << by_words.err;
  // A prefix of the whole search.
  const codec::Family whole = parsed(tagmint(quick()));
  const codec::Family part = parsed(by_words);
  for (codec::TagId id = 0; id < part.size(); ++id) {
    EXPECT_EQ(part.codeword(id), whole.codeword(id));
  }
}

TEST(Generate, BestOfSeveralAttemptsIsKeptAndEachIsReported) {
  const ProgramResult result = tagmint(quick({"--attempts", "3", "--order", "seed:100"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::size_t most = 0;
  for (const char* seed : {"seed:100", "seed:101", "seed:102"}) {
    const std::size_t codes = parsed(tagmint(quick({"--order", seed}))).size();
    most = std::max(most, codes);
    EXPECT_NE(result.err.find(fmt::format("{}: {} codes", seed, codes)), std::string::npos)
        << result.err;
  }
  EXPECT_EQ(parsed(result).size(), most);
}

TEST(Generate, NameAndComplexityAreRecorded) {
  const codec::Family family =
      parsed(tagmint(quick({"--name", "mine", "--complexity", "none", "--order", "apriltag3"})));
  EXPECT_EQ(family.name(), "mine");
  EXPECT_EQ(family.complexity(), codec::Complexity{});
  EXPECT_EQ(family.origin().order, "apriltag3");
}

TEST(Generate, TimeLimitKeepsWhatWasFound) {
  const ScratchFolder folder;
  std::vector<std::string> words = endless(folder.file("part.json"));
  words.insert(words.end(), {"--time-limit", "0.1s"});
  const ProgramResult result = tagmint(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("(--time-limit)"), std::string::npos) << result.err;
  const codec::Family family = codec::read_family(folder.file("part.json"));
  EXPECT_EQ(family.codeword(0), codec::find_family("tag36h11")->codeword(0));
}

TEST(Generate, InterruptionGives130AndLeavesNoFile) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ScratchFolder folder;
    RunningProgram program(tagmint_words(endless(folder.file("never.json"))));
    ASSERT_TRUE(program.wait_for_stderr("{\"task\":\"search\""));
    program.send_signal(signal);
    const ProgramResult result = program.finish();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_TRUE(
        result.err.ends_with("tagmint: error: interrupted; nothing was written; give --checkpoint "
                             "to be able to go on, or --time-limit to keep what is found\n"))
        << result.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
  }
}

TEST(Generate, KilledSearchLeavesNoFileAndTheOldOneWhole) {
  const ScratchFolder folder;
  write_file(folder.file("old.json"), "as it was");
  RunningProgram program(tagmint_words(endless(folder.file("old.json"))));
  ASSERT_TRUE(program.wait_for_stderr("{\"task\":\"search\""));
  program.send_signal(SIGKILL);
  EXPECT_EQ(program.finish().exit_code, 128 + SIGKILL);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"old.json"});
  EXPECT_EQ(read_file(folder.file("old.json")), "as it was");
}

/// Runs until the bar is seen (true) or the search has ended without one (false).
bool shows_bar(const std::string& progress, Stderr stderr_kind) {
  const std::vector<std::string> words = {"generate",      "--layout", "classic:10",
                                          "--min-hamming", "11",       "--progress=" + progress,
                                          "--time-limit",  "1s"};
  RunningProgram program(tagmint_words(words), stderr_kind, {"TERM=xterm"});
  return program.wait_for_stderr("\r\033[Ksearch [");
}

TEST(Generate, ProgressBarIsShownOnATerminalOrWhenAskedFor) {
  EXPECT_TRUE(shows_bar("auto", Stderr::Terminal));
  EXPECT_TRUE(shows_bar("always", Stderr::Pipe));
  EXPECT_FALSE(shows_bar("auto", Stderr::Pipe));
  EXPECT_FALSE(shows_bar("never", Stderr::Terminal));
}

TEST(Generate, ImpossibleSearchesAreUsageErrors) {
  expect_fault({"generate", "--min-hamming", "5"}, 2,
               "--layout is missing; see 'tagmint generate --help'");
  expect_fault({"generate", "--layout", "classc:8", "--min-hamming", "5"}, 2,
               "unknown layout 'classc:8' (--layout); did you mean 'classic'? layouts are "
               "classic:W, standard:W, circle:W, custom:ROWS");
  expect_fault({"generate", "--layout", "classic:8", "--min-hamming", "17"}, 2,
               "distance 17 is not possible with the layout's 16 bits (--min-hamming); ask for 1 "
               "to 16");
  expect_fault({"generate", "--layout", "classic:8", "--min-hamming", "0"}, 2,
               "'0' is not a number from 1 to 64 (--min-hamming); see 'tagmint generate --help'");
  expect_fault(quick({"--attempts", "0"}), 2,
               "'0' is not a number from 1 to 1000000 (--attempts); see 'tagmint generate --help'");
  expect_fault(quick({"--name", "a b"}), 2,
               "family name 'a b' is not possible (--name); use letters, digits, '_', '-' and "
               "'.'");
  for (const char* option : {"--limit-codes", "--limit-words"}) {
    for (const char* count : {"0", "-1", "1.5", "many", "99999999999999999999"}) {
      expect_fault(quick({fmt::format("{}={}", option, count)}), 2,
                   fmt::format("'{}' is not a count ({}); write a whole number of at least 1, like "
                               "5000 or 1e9",
                               count, option));
    }
  }
  expect_fault(quick({"--time-limit", "5"}), 2,
               "the time '5' has no unit (--time-limit); write numbers with s, min, h or d, like "
               "90s or 1h30min");
}

TEST(Generate, MisspeltRulesAndOrdersAreTold) {
  for (const auto& [option, word, meant] :
       {std::tuple{"--complexity", "rectangle:5", "did you mean 'rectangles'?"},
        std::tuple{"--complexity", "enregy:0.3", "did you mean 'energy'?"},
        std::tuple{"--order", "apriltag4", "did you mean 'apriltag2'?"}}) {
    const ProgramResult result = tagmint(quick({option, word}));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find(fmt::format("({}); {}", option, meant)), std::string::npos)
        << result.err;
  }
}

TEST(Generate, RotationCodeTellsItsLevelsAndHowManyThereCouldBe) {
  const ProgramResult result =
      tagmint({"generate", "--method", "rotation-code", "--layout", "classic:8", "--min-hamming",
               "5", "--levels", "8", "--codes", "50", "--name", "mine"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const codec::Family family = parsed(result);
  EXPECT_EQ(family.name(), "mine");
  EXPECT_EQ(family.size(), 50u);
  EXPECT_EQ(family.levels().front().min_hamming, 8);
  EXPECT_NE(result.err.find("tagmint: the first of 60 (--codes)\n"), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("tagmint: ids 0-49: distance 5; "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("no family of 16 bits at distance 5 has more than 103 codes"),
            std::string::npos)
      << result.err;
}

TEST(Generate, OptionsThatDoNotGoTogetherAreRefusedInWords) {
  expect_fault(quick({"--levels", "8"}), 2,
               "--method lexicode has no --levels (--levels); leave it out, or choose the other "
               "method");
  expect_fault(quick({"--method", "rotation-code", "--time-limit", "1s"}), 2,
               "--method rotation-code has no --time-limit (--time-limit); leave it out, or choose "
               "the other method");
  expect_fault(quick({"--resume"}), 2,
               "nothing says where to go on from (--resume); give --checkpoint FILE too");
}

TEST(Generate, PlaceThatCannotBeWrittenIsToldBeforeTheSearch) {
  const ScratchFolder folder;
  const std::string nowhere = folder.file("missing") + "/my.json";
  expect_fault(endless(nowhere), 4,
               "cannot write: there is no folder " + folder.file("missing") + " (" + nowhere +
                   "); make it first or choose another place");
  const std::string place = folder.path().string();
  expect_fault(
      endless(place), 4,
      "cannot write a file: it is a folder (" + place + "); give the name of a file in it");
  expect_fault(endless(folder.file("my.txt")), 2,
               "the extension '.txt' is not that of a family file (--output); end the name with "
               ".json");
}

TEST(Generate, ReadOnlyFolderIsAnOutputFault) {
  // /proc cannot be written even by root, whom file permissions do not hold back.
  const ProgramResult result = tagmint(quick({"-o", "/proc/my.json"}));
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(result.err.starts_with("tagmint: error: cannot write")) << result.err;
  EXPECT_NE(result.err.find("/proc/my.json"), std::string::npos) << result.err;
}

TEST(Generate, NothingFoundIsTheAnswerNo) {
  expect_fault({"generate", "--layout", "classic:8", "--min-hamming", "16"}, 1,
               "no code found, all 2^16 words searched (--layout, --min-hamming); ask for a "
               "smaller distance or complexity, or search more words");
}

}  // namespace
}  // namespace tagmint::test
