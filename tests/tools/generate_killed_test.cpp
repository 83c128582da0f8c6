// Searches that are killed and interrupted at random moments give the family of an undisturbed one.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "support/fixed_random.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

namespace fs = std::filesystem;
using tagmint::testing::FixedRandom;

/// A search of some seconds.
std::vector<std::string> search(const std::string& output, const std::vector<std::string>& more) {
  std::vector<std::string> words = {"generate", "--layout", "classic:10", "--min-hamming",
                                    "10",       "-o",       output};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Ends a search `times` times at random moments, each time going on from the checkpoint; one that
/// was quicker is begun again. The family must be `expected` whenever there is one.
///   whole_s   what an undisturbed search takes; the moments are such that all together get through
void disturb(int signal, int times, std::uint64_t seed, double whole_s,
             const std::string& expected) {
  const ScratchFolder folder;
  const std::string output = folder.file("my.json");
  const std::vector<std::string> words =
      search(output, {"--checkpoint", folder.file("kept"), "--resume", "--threads", "1"});
  const int exit_code = signal == SIGKILL ? 128 + SIGKILL : 130;
  FixedRandom random(seed);
  const auto expect_whole = [&] {
    ASSERT_EQ(read_file(output), expected);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"my.json"});
    fs::remove(output);
  };
  const double longest_s = std::max(0.35, 3 * whole_s / times);
  int went_on = 0;
  int in_the_list = 0;
  for (int ended = 0; ended < times;) {
    RunningProgram program(tagmint_words(words));
    std::this_thread::sleep_for(std::chrono::duration<double>(random.real(0.05, longest_s)));
    program.send_signal(signal);
    const ProgramResult result = program.finish();
    SCOPED_TRACE(result.err);
    if (result.exit_code == 0) {
      expect_whole();
      continue;
    }
    ASSERT_EQ(result.exit_code, exit_code);
    ++ended;
    // Killed between the family and the end of the checkpoint, the family is there and whole.
    EXPECT_TRUE(!fs::exists(output) || read_file(output) == expected);
    went_on += result.err.find("going on from") != std::string::npos;
    in_the_list += result.err.find(": phase 2") != std::string::npos;
  }
  const ProgramResult last = tagmint(words);
  ASSERT_EQ(last.exit_code, 0) << last.err;
  expect_whole();
  EXPECT_GT(went_on, times / 2);
  EXPECT_GT(in_the_list, 0);
}

TEST(GenerateKilled, SearchThatIsKilledAndInterruptedGivesTheSameFamily) {
  const ScratchFolder folder;
  const std::string output = folder.file("undisturbed.json");
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(tagmint(search(output, {"--threads", "1"})).exit_code, 0);
  const double whole_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_EQ(codec::family_digest(codec::read_family(output)),
            codec::family_digest(*codec::find_family("tag36h10")));
  const std::string expected = read_file(output);
  disturb(SIGKILL, 20, 1, whole_s, expected);
  disturb(SIGINT, 5, 2, whole_s, expected);
}

}  // namespace
}  // namespace tagmint::test
