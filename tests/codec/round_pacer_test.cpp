#include "search/round_pacer.h"

#include <gtest/gtest.h>

namespace tagmint::codec {
namespace {

using std::chrono::seconds;

TEST(RoundPacer, DoublesShortRoundsUpToTheMost) {
  RoundPacer pacer(4, 8, 50);
  EXPECT_EQ(pacer.pieces(), 4u);
  for (const std::uint64_t expected : {8, 16, 32, 50, 50}) {
    pacer.learn(seconds(1), seconds(10));
    EXPECT_EQ(pacer.pieces(), expected);
  }
}

TEST(RoundPacer, LeavesRoundsOfTheRightLengthAlone) {
  RoundPacer pacer(4, 4, 64);
  pacer.learn(seconds(7), seconds(10));
  EXPECT_EQ(pacer.pieces(), 4u);
}

TEST(RoundPacer, HalvesLongRoundsWhileTheyStayWorthwhile) {
  RoundPacer pacer(4, 10, 64);
  for (int i = 0; i < 4; ++i) pacer.learn(seconds(1), seconds(10));
  EXPECT_EQ(pacer.pieces(), 64u);
  for (const std::uint64_t expected : {32, 16, 10, 10}) {
    pacer.learn(seconds(11), seconds(10));
    EXPECT_EQ(pacer.pieces(), expected);
  }
}

TEST(RoundPacer, GrowsToWorthwhileRoundsHoweverLongTheyTake) {
  RoundPacer pacer(4, 10, 64);
  for (const std::uint64_t expected : {8, 16, 10}) {
    pacer.learn(seconds(11), seconds(10));
    EXPECT_EQ(pacer.pieces(), expected);
  }
}

TEST(RoundPacer, HalvesRoundsThatTakeFarTooLongDownToTheFewest) {
  RoundPacer pacer(4, 64, 64);
  for (int i = 0; i < 3; ++i) pacer.learn(seconds(1), seconds(10));
  EXPECT_EQ(pacer.pieces(), 32u);
  for (const std::uint64_t expected : {16, 8, 4, 4}) {
    pacer.learn(seconds(51), seconds(10));
    EXPECT_EQ(pacer.pieces(), expected);
  }
}

TEST(RoundPacer, HalvesRoundsInVainDownToTheFewest) {
  RoundPacer pacer(4, 10, 64);
  for (int i = 0; i < 3; ++i) pacer.learn(seconds(1), seconds(10));
  EXPECT_EQ(pacer.pieces(), 32u);
  for (const std::uint64_t expected : {16, 8, 4, 4}) {
    pacer.learn(seconds(1), seconds(10), true);
    EXPECT_EQ(pacer.pieces(), expected);
  }
}

}  // namespace
}  // namespace tagmint::codec
