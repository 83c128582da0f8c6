// `generate` with a checkpoint: what it says, keeps and refuses.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// `generate` with a search and a checkpoint, and more words.
Words generate(const Words& search, const std::string& checkpoint, const Words& more) {
  Words words = {"generate"};
  words.insert(words.end(), search.begin(), search.end());
  words.insert(words.end(), {"--checkpoint", checkpoint});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const Words kQuick = {"--layout", "classic:8", "--min-hamming", "5"};
/// Takes days; finds its first hundreds of codes at once.
const Words kEndless = {"--layout", "standard:10", "--min-hamming", "20"};

/// Begins the endless search; false when it ended before it was seen to search.
bool begin_endless(RunningProgram& program) {
  return program.wait_for_stderr("{\"task\":\"search\"");
}

/// The family that a search gives when nobody disturbs it.
std::string undisturbed(const Words& search) {
  Words words = {"generate"};
  words.insert(words.end(), search.begin(), search.end());
  return tagmint(words).out;
}

void expect_prefix(const codec::Family& part, const codec::Family& whole) {
  ASSERT_LE(part.size(), whole.size());
  for (codec::TagId id = 0; id < part.size(); ++id) {
    ASSERT_EQ(part.codeword(id), whole.codeword(id)) << id;
  }
}

TEST(GenerateCheckpoint, InterruptedSearchIsKeptAndGoesOn) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ScratchFolder folder;
    const std::string kept = folder.file("kept");
    const std::string output = folder.file("my.json");
    RunningProgram program(
        tagmint_words(generate(kEndless, kept, {"-o", output, "--progress=json"})));
    ASSERT_TRUE(begin_endless(program));
    program.send_signal(signal);
    const ProgramResult result = program.finish();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_TRUE(result.err.ends_with("tagmint: error: interrupted; what was searched is in " +
                                     kept + "; go on with --resume\n"))
        << result.err;
    EXPECT_EQ(folder.names(), Words{"kept"});

    const ProgramResult more =
        tagmint(generate(kEndless, kept, {"-o", output, "--resume", "--time-limit", "0.1s"}));
    EXPECT_EQ(more.exit_code, 0) << more.err;
    EXPECT_TRUE(more.err.starts_with("tagmint: going on from " + kept + ": phase ")) << more.err;
    EXPECT_EQ(more.err.find("phase 1, 0 codes"), std::string::npos) << more.err;
    EXPECT_GT(codec::read_family(output).size(), 0u);
  }
}

TEST(GenerateCheckpoint, ProgressNamesThePhase) {
  RunningProgram program(tagmint_words(
      {"generate", "--layout", "standard:10", "--min-hamming", "20", "--progress=json"}));
  EXPECT_TRUE(program.wait_for_stderr("\"note\":\"phase 1 of 3, "));
}

TEST(GenerateCheckpoint, OneSearchAtATimeUsesIt) {
  const ScratchFolder folder;
  const std::string kept = folder.file("kept");
  RunningProgram program(tagmint_words(generate(kEndless, kept, {"--progress=json"})));
  ASSERT_TRUE(begin_endless(program));
  expect_fault(
      generate(kEndless, kept, {"--resume"}), 4,
      "another search is using the checkpoint (" + kept + "); wait for it, or give another file");
  expect_fault(
      generate(kEndless, kept, {}), 4,
      "the checkpoint exists already (" + kept + "); go on from it with --resume, or remove it");
}

TEST(GenerateCheckpoint, ResumeWithoutAFileBeginsAndTheFileGoesWithTheEnd) {
  const ScratchFolder folder;
  const std::string kept = folder.file("kept");
  const ProgramResult result = tagmint(generate(kQuick, kept, {"--resume"}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err,
            "tagmint: no checkpoint yet: searching from the beginning (" + kept +
                ")\n"
                "tagmint: tag16h5: 30 codes, order apriltag2, all 2^16 words searched\n");
  EXPECT_EQ(result.out, undisturbed(kQuick));
  EXPECT_EQ(folder.names(), Words{});
}

TEST(GenerateCheckpoint, LargerLimitGoesOn) {
  const ScratchFolder folder;
  const std::string kept = folder.file("kept");
  const ProgramResult first = tagmint(generate(kQuick, kept, {"--limit-words", "1e3"}));
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_TRUE(
      first.err.ends_with("tagmint: " + kept + " is kept: --resume with a larger limit goes on\n"))
      << first.err;
  const ProgramResult second = tagmint(generate(kQuick, kept, {"--resume", "--limit-codes", "25"}));
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(codec::parse_family(second.out, "stdout").size(), 25u);
  expect_fault(generate(kQuick, kept, {"--resume", "--limit-codes", "24", "--quiet"}), 2,
               "the search has already found 25 codes, more than the limit of 24 codes");
  const ProgramResult third = tagmint(generate(kQuick, kept, {"--resume", "--limit-words", "1e4"}));
  expect_prefix(codec::parse_family(second.out, "second"), codec::parse_family(third.out, "third"));
  EXPECT_EQ(tagmint(generate(kQuick, kept, {"--resume"})).out, undisturbed(kQuick));
  EXPECT_EQ(folder.names(), Words{});
}

TEST(GenerateCheckpoint, TimeLimitKeepsIt) {
  const ScratchFolder folder;
  const std::string kept = folder.file("kept");
  const auto run_for = [&](const char* time) {
    const ProgramResult result =
        tagmint(generate(kEndless, kept, {"--resume", "--time-limit", time}));
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_TRUE(
        result.err.ends_with("tagmint: " + kept + " is kept: --resume with more time goes on\n"))
        << result.err;
    return codec::parse_family(result.out, "stdout");
  };
  const codec::Family first = run_for("0.1s");
  expect_prefix(first, run_for("0.3s"));
}

TEST(GenerateCheckpoint, AttemptsGoOnWhereTheyWere) {
  const ScratchFolder folder;
  const std::string kept = folder.file("kept");
  Words many = kQuick;
  many.insert(many.end(), {"--attempts", "40", "--order", "seed:1"});
  RunningProgram program(tagmint_words(generate(many, kept, {})));
  ASSERT_TRUE(program.wait_for_stderr("attempt 3 of 40, "));
  program.send_signal(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);

  const ProgramResult rest = tagmint(generate(many, kept, {"--resume"}));
  EXPECT_EQ(rest.exit_code, 0);
  EXPECT_TRUE(rest.err.starts_with("tagmint: going on from " + kept + ": attempt ")) << rest.err;
  EXPECT_EQ(rest.err.find("attempt 3 of 40, seed:3: "), std::string::npos) << rest.err;
  EXPECT_NE(rest.err.find("attempt 40 of 40, seed:40: "), std::string::npos) << rest.err;
  EXPECT_EQ(rest.out, undisturbed(many));
  EXPECT_EQ(folder.names(), Words{});
}

TEST(GenerateCheckpoint, ThatOfAnotherSearchIsRefused) {
  const ScratchFolder folder;
  const std::string kept = folder.file("kept");
  ASSERT_EQ(tagmint(generate(kQuick, kept, {"--limit-words", "1e3"})).exit_code, 0);
  expect_fault(generate({"--layout", "classic:8", "--min-hamming", "6"}, kept, {"--resume"}), 3,
               "the checkpoint belongs to another search: min_hamming is 5 there, 6 here (" + kept +
                   "); repeat the options of that search, or search anew with another file");
  write_file(kept, "else");
  expect_fault(generate(kQuick, kept, {"--resume"}), 3,
               "is not a checkpoint of a search (" + kept +
                   "); give the file that --checkpoint has written");
  EXPECT_EQ(read_file(kept), "else");
}

TEST(GenerateCheckpoint, PlacesWhereItCannotBeAreTold) {
  const ScratchFolder folder;
  const std::string missing = folder.file("missing");
  expect_fault(generate(kQuick, missing + "/kept", {}), 4,
               "cannot write the file: No such file or directory (" + missing +
                   "/kept); make the folder " + missing + " first");
  const std::string place = folder.path().string();
  expect_fault(generate(kQuick, place, {}), 4,
               "cannot write the file: Is a directory (" + place +
                   "); give the name of a file, not of a folder");
  expect_fault(generate(kQuick, place, {"--resume"}), 3,
               "the checkpoint is not a file (" + place + "); give the name of its file");
  const std::string same = folder.file("my.json");
  expect_fault(generate(kQuick, same, {"-o", place + "/./my.json"}), 2,
               "the checkpoint and the family would be the same file (--checkpoint); give it "
               "another name than --output");
  EXPECT_EQ(folder.names(), Words{});
}

/// Runs the program where no file may have more than 512 bytes.
ProgramResult run_on_full_disk(const Words& arguments) {
  Words words = {"/bin/sh", "-c", R"(trap '' XFSZ; ulimit -f 1; exec "$@")", "sh"};
  for (const std::string& word : tagmint_words(arguments)) words.push_back(word);
  return run(words);
}

TEST(GenerateCheckpoint, FullDiskIsAnOutputFaultThatLosesNothing) {
  const ScratchFolder folder;
  const std::string kept = folder.file("kept");
  const ProgramResult result = run_on_full_disk(generate(kEndless, kept, {}));
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err, "tagmint: error: cannot write the file: File too large (" + kept +
                            "); choose a place that can be written to\n");
  const ProgramResult more =
      tagmint(generate(kEndless, kept, {"--resume", "--time-limit", "0.1s"}));
  EXPECT_EQ(more.exit_code, 0) << more.err;
}

}  // namespace
}  // namespace tagmint::test
