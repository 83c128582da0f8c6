#include "ranked_bits.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/fixed_random.h"

namespace tagmint::codec {
namespace {

TEST(RankedBits, CountsAndFindsAsAWalkDoes) {
  testing::FixedRandom random(1);
  for (const int words : {1, 7, 8, 9, 40}) {
    for (const int thinned : {0, 1, 4, 9}) {
      std::vector<std::uint64_t> bits(words);
      for (std::uint64_t& word : bits) {
        word = random.bits();
        for (int i = 0; i < thinned; ++i) word &= random.bits();
      }
      const RankedBits ranked(bits);
      std::size_t ones = 0;
      for (std::size_t place = 0; place < 64 * bits.size(); ++place) {
        const bool is_one = ((bits[place / 64] >> (place % 64)) & 1) != 0;
        ASSERT_EQ(ranked.test(place), is_one);
        ASSERT_EQ(ranked.rank(place), ones);
        if (!is_one) continue;
        ASSERT_EQ(ranked.select(ones), place);
        ++ones;
      }
      EXPECT_EQ(ranked.ones(), ones);
    }
  }
}

TEST(RankedBits, TakesBlocksWithoutOnes) {
  std::vector<std::uint64_t> bits(32, 0);
  bits[3] = 8;
  bits[31] = std::uint64_t{1} << 63;
  const RankedBits ranked(bits);
  EXPECT_EQ(ranked.ones(), 2u);
  EXPECT_EQ(ranked.select(0), 3u * 64 + 3);
  EXPECT_EQ(ranked.select(1), 32u * 64 - 1);
  EXPECT_EQ(ranked.rank(20 * 64), 1u);
}

TEST(RankedBits, MayBeEmpty) { EXPECT_EQ(RankedBits().ones(), 0u); }

}  // namespace
}  // namespace tagmint::codec
