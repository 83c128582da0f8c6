#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "support/places.h"
#include "support/running_program.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"

namespace tagmint::test {
namespace {

using Words = std::vector<std::string>;

const Words kRootMayRunIt = {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"};

Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// `mpirun` with so many ranks of any program.
Words mpirun_words(int ranks, const Words& program) {
  return joined({TAGMINT_MPIRUN, "--oversubscribe", "-n", std::to_string(ranks)}, program);
}

ProgramResult mpirun(int ranks, const Words& arguments) {
  return RunningProgram(mpirun_words(ranks, tagmint_words(arguments)), Stderr::Pipe, kRootMayRunIt)
      .finish();
}

/// Runs the program through a shell that leaves the process id of each rank in FOLDER/RANK.
Words with_pid_files(int ranks, const ScratchFolder& folder, const Words& arguments) {
  const std::string script =
      fmt::format("echo $$ > {}/$OMPI_COMM_WORLD_RANK; exec \"$0\" \"$@\"", folder.path().string());
  return mpirun_words(ranks, joined({"/bin/sh", "-c", script}, tagmint_words(arguments)));
}

int pid_of_rank(const ScratchFolder& folder, int rank) {
  return std::atoi(read_file(folder.file(std::to_string(rank))).c_str());
}

int count_of(std::string_view text, std::string_view part) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; at += part.size()) ++count;
  return count;
}

/// A search that would run for hours; tells its progress.
Words endless() {
  return {"generate", "--layout", "classic:10", "--min-hamming", "7", "--progress=json"};
}

/// A search of all three phases that takes a second: classic:10 without the corners of its data.
Words tree_search() {
  return {"generate", "--min-hamming", "8", "--layout",
          "custom:wwwwwwwwww/wbbbbbbbbw/wbbddddbbw/wbddddddbw/wbddddddbw/"
          "wbddddddbw/wbddddddbw/wbbddddbbw/wbbbbbbbbw/wwwwwwwwww"};
}

TEST(Mpirun, FamilyIsTheSameForAnyNumberOfRanks) {
  const Words plain_search = {"generate", "--layout", "classic:9", "--min-hamming", "9"};
  for (const Words& search : {plain_search, tree_search()}) {
    const ProgramResult alone = tagmint(search);
    ASSERT_EQ(alone.exit_code, 0);
    for (const int ranks : {1, 2, 4}) {
      SCOPED_TRACE(ranks);
      const ProgramResult together = mpirun(ranks, search);
      EXPECT_EQ(together.exit_code, 0);
      EXPECT_EQ(together.out, alone.out);
      EXPECT_TRUE(together.err.ends_with(alone.err)) << together.err;
    }
  }
}

TEST(Mpirun, AttemptsAreTheSame) {
  const Words search = {"generate",   "--layout", "classic:8", "--min-hamming", "5",
                        "--attempts", "4",        "--order",   "seed:7"};
  const ProgramResult alone = tagmint(search);
  const ProgramResult together = mpirun(3, joined(search, {"--threads", "1"}));
  EXPECT_EQ(together.out, alone.out);
  EXPECT_EQ(together.err, "tagmint: 3 processes with 3 threads together\n" + alone.err);
}

TEST(Mpirun, ASearchGoesOnWithAnotherNumberOfRanks) {
  const ScratchFolder folder;
  const Words search = joined(tree_search(), {"--checkpoint", folder.file("c"), "--resume"});
  const ProgramResult part = mpirun(2, joined(search, {"--time-limit", "0.2s"}));
  EXPECT_EQ(part.exit_code, 0) << part.err;
  EXPECT_NE(part.err.find("is kept: --resume with more time goes on"), std::string::npos)
      << part.err;
  const ProgramResult rest = mpirun(3, search);
  EXPECT_NE(rest.err.find("going on from"), std::string::npos) << rest.err;
  EXPECT_EQ(rest.out, tagmint(tree_search()).out);
}

TEST(Mpirun, AFaultIsToldOnce) {
  const ProgramResult result = mpirun(3, {"generate", "--layout", "classic:10"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(count_of(result.err, "tagmint: error: --min-hamming is missing"), 1) << result.err;
}

TEST(Mpirun, CompletenessIsProvenTogether) {
  const Words check = {"check", "--complete", "tag36h11"};
  const ProgramResult together = mpirun(2, check);
  EXPECT_EQ(together.exit_code, 0) << together.err;
  EXPECT_EQ(together.out, tagmint(check).out);
}

TEST(Mpirun, OtherCommandsRunOnce) {
  EXPECT_EQ(mpirun(2, {"families"}).out, tagmint({"families"}).out);
}

TEST(Mpirun, RanksWithDifferentCommandLinesRunEachItsOwn) {
  const ScratchFolder folder;
  const std::string script =
      fmt::format("exec \"$0\" encode tag36h11 $OMPI_COMM_WORLD_RANK -o {}/$OMPI_COMM_WORLD_RANK",
                  folder.path().string());
  const Words encode = {"/bin/sh", "-c", script, program_path()};
  const ProgramResult result =
      RunningProgram(mpirun_words(2, encode), Stderr::Pipe, kRootMayRunIt).finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* id : {"0", "1"}) {
    EXPECT_EQ(read_file(folder.file(id)), tagmint({"encode", "tag36h11", id}).out);
  }
}

TEST(Mpirun, ASearchOfProcessesThatDoNotFindEachOtherIsRefused) {
  const Words strangers = {"PMI_RANK=0", "PMI_SIZE=4"};  // of a launcher that does not help them
  const ProgramResult search =
      RunningProgram(tagmint_words(tree_search()), Stderr::Pipe, strangers).finish();
  EXPECT_EQ(search.exit_code, 2);
  EXPECT_NE(search.err.find("4 processes were started that do not find each other"),
            std::string::npos)
      << search.err;
  const ProgramResult other =
      RunningProgram(tagmint_words({"families"}), Stderr::Pipe, strangers).finish();
  EXPECT_EQ(other.out, tagmint({"families"}).out);
}

TEST(Mpirun, TheLeaderEndsTheProgramWhenItIsInterrupted) {
  const ScratchFolder folder;
  RunningProgram program(with_pid_files(2, folder, endless()), Stderr::Pipe, kRootMayRunIt);
  ASSERT_TRUE(program.wait_for_stderr("\"done\""));
  kill(pid_of_rank(folder, 1), SIGINT);  // the other ranks do not mind
  kill(pid_of_rank(folder, 1), SIGTERM);
  kill(pid_of_rank(folder, 0), SIGINT);
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_EQ(count_of(result.err, "tagmint: error: interrupted"), 1) << result.err;
  EXPECT_EQ(result.out, "");
}

TEST(Mpirun, AStoppedLauncherLetsTheLeaderEnd) {
  // It gives its processes a second; on a machine that does much besides they need more.
  const Words patient = {"--mca", "odls_base_sigkill_timeout", "4"};
  RunningProgram program(mpirun_words(2, joined(patient, tagmint_words(endless()))), Stderr::Pipe,
                         kRootMayRunIt);
  ASSERT_TRUE(program.wait_for_stderr("\"done\""));
  program.send_signal(SIGTERM);
  const ProgramResult result = program.finish();
  EXPECT_NE(result.exit_code, 0);
  EXPECT_EQ(count_of(result.err, "tagmint: error: interrupted"), 1) << result.err;
}

TEST(Mpirun, AKilledRankEndsTheJobWhichGoesOnFromItsCheckpoint) {
  const ScratchFolder folder;
  const Words search =
      joined(tree_search(), {"--checkpoint", folder.file("c"), "--resume", "--progress=json"});
  RunningProgram program(with_pid_files(2, folder, search), Stderr::Pipe, kRootMayRunIt);
  ASSERT_TRUE(program.wait_for_stderr("\"done\""));
  kill(pid_of_rank(folder, 1), SIGKILL);
  EXPECT_NE(program.finish().exit_code, 0);
  const ProgramResult rest = mpirun(4, search);
  EXPECT_NE(rest.err.find("going on from"), std::string::npos) << rest.err;
  EXPECT_EQ(rest.out, tagmint(tree_search()).out);
}

}  // namespace
}  // namespace tagmint::test
