#include "cluster/round_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tagmint::cluster {
namespace {

TEST(RankSpeeds, ARankThatHasNotWorkedIsTakenForAnAverageOne) {
  RankSpeeds speeds(3);
  EXPECT_EQ(speeds.of(1), 0);
  EXPECT_EQ(speeds.of_all(), 0);
  speeds.learn(0, 100, 1.0);
  speeds.learn(2, 300, 1.0);
  EXPECT_DOUBLE_EQ(speeds.of(0), 100);
  EXPECT_DOUBLE_EQ(speeds.of(1), 200);
  EXPECT_DOUBLE_EQ(speeds.of_all(), 600);
}

TEST(RankSpeeds, FollowsALastingChange) {
  RankSpeeds speeds(1);
  speeds.learn(0, 100, 1.0);
  for (int i = 0; i < 20; ++i) speeds.learn(0, 500, 1.0);
  EXPECT_NEAR(speeds.of(0), 500, 1);
}

/// Chunks of a round that ranks of these speeds take in turn.
std::vector<Chunk> divided(std::uint64_t first, std::uint64_t count, RankSpeeds& speeds,
                           int ranks) {
  RoundDivision division(first, count, speeds);
  std::vector<Chunk> chunks;
  for (int rank = 0; const auto chunk = division.take(rank); rank = (rank + 1) % ranks) {
    chunks.push_back(*chunk);
  }
  return chunks;
}

TEST(RoundDivision, ChunksFollowOneAnotherAndCoverTheRound) {
  for (const double speed : {0.0, 0.5, 3e3, 1e9}) {
    RankSpeeds speeds(3);
    if (speed > 0) speeds.learn(1, 1'000'000'000, 1e9 / speed);
    std::uint64_t next = 17;
    for (const Chunk& chunk : divided(17, 1000, speeds, 3)) {
      EXPECT_EQ(chunk.first, next);
      EXPECT_GE(chunk.count, 1U);
      next += chunk.count;
    }
    EXPECT_EQ(next, 1017U);
  }
}

TEST(RoundDivision, AFasterRankGetsLongerChunks) {
  RankSpeeds speeds(2);
  speeds.learn(0, 1'000'000, 1.0);
  speeds.learn(1, 4'000'000, 1.0);
  RoundDivision division(0, 5'000'000, speeds);
  const auto slow = division.take(0);
  const auto fast = division.take(1);
  ASSERT_TRUE(slow && fast);
  EXPECT_EQ(slow->count, 40'000U);  // 40 ms
  EXPECT_EQ(fast->count, 160'000U);
}

TEST(RoundDivision, ChunksShrinkTowardsTheEnd) {
  RankSpeeds speeds(2);
  speeds.learn(0, 1'000'000, 1.0);
  const std::vector<Chunk> chunks = divided(0, 1'000'000, speeds, 2);
  ASSERT_GT(chunks.size(), 4U);
  for (std::size_t i = 1; i < chunks.size(); ++i) {
    EXPECT_LE(chunks[i].count, chunks[i - 1].count);
  }
  EXPECT_LE(chunks.back().count, 2000U);  // 2 ms
}

TEST(RoundDivision, NobodyTakesFromACancelledRound) {
  RankSpeeds speeds(1);
  RoundDivision division(0, 10, speeds);
  EXPECT_TRUE(division.take(0));
  division.cancel();
  EXPECT_FALSE(division.take(0));
}

}  // namespace
}  // namespace tagmint::cluster
