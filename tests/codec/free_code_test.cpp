#include "search/rotation/free_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "search/rotation/chain_search.h"
#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

/// The largest minimum weight of a free code of two generators, by trying all: one is 1 at the
/// first place, the other at the second, and both are arbitrary at the rest. Every free code is
/// such a one after an exchange of places.
int best_distance_of_two_generators(int bits) {
  const int places = bits / 4;
  const int entries = 1 << 4 * (places - 2);
  const auto generator = [&](int own, int entry) {
    Codeword word = Codeword{1} << (bits - 1 - own);
    for (int place = 2; place < places; ++place, entry >>= 4) {
      for (int block = 0; block < 4; ++block) {
        if (entry >> block & 1) word |= Codeword{1} << (bits - 1 - block * places - place);
      }
    }
    return word;
  };
  int best = 0;
  for (int first = 0; first < entries; ++first) {
    for (int second = 0; second < entries; ++second) {
      std::vector<Codeword> basis;
      for (const Codeword word : {generator(0, first), generator(1, second)}) {
        for (int turn = 0; turn < 4; ++turn) basis.push_back(rotate(word, bits, turn));
      }
      best = std::max(best, test::plain_least_weight(basis));
    }
  }
  return best;
}

TEST(FreeCode, IsFoundWhereverPlainEnumerationFindsOne) {
  for (const int bits : {12, 16}) {
    const int best = best_distance_of_two_generators(bits);
    for (int distance = 1; distance <= best + 2; ++distance) {
      RandomChoice random(1);
      WorkBudget budget({1e7});
      const auto code = find_free_code(bits, 2, distance, random, budget);
      ASSERT_EQ(code.has_value(), distance <= best) << bits << " bits, distance " << distance;
      EXPECT_EQ(budget.is_spent(), !code.has_value());
      if (!code) continue;
      EXPECT_EQ(code->dimension(), 8);
      EXPECT_TRUE(test::prefixes_are_closed(*code));
      EXPECT_GE(test::plain_least_weight(code->basis()), distance);
    }
  }
}

TEST(FreeCode, HasAsFewWordsThatAHalfTurnKeepsAsCanBe) {
  RandomChoice random(2);
  WorkBudget budget({1e8});
  const auto code = find_free_code(24, 3, 6, random, budget);
  ASSERT_TRUE(code);
  EXPECT_EQ(code->dimension(), 12);
  EXPECT_EQ(tags_of(*code), (4096 - 64) / 4.0);
}

TEST(FreeCode, IsFoundWhereFlipsAreTooManyToTryAll) {
  RandomChoice random(3);
  WorkBudget budget({1e9});
  const auto code = find_free_code(64, 2, 24, random, budget);
  ASSERT_TRUE(code);
  EXPECT_EQ(code->dimension(), 8);
  EXPECT_GE(test::plain_least_weight(code->basis()), 24);
}

TEST(FreeCode, SixteenDimensionsAtDistanceTenOfThirtySixBits) {
  RandomChoice random(5);
  WorkBudget budget({2e10});
  const auto code = find_free_code(36, 4, 10, random, budget);
  ASSERT_TRUE(code);
  EXPECT_EQ(code->dimension(), 16);
  EXPECT_EQ(tags_of(*code), 16320);
  EXPECT_EQ(test::plain_least_weight(code->basis()), 10);
}

TEST(FreeCode, IsTheSameForTheSameSeed) {
  const auto found = [](std::uint64_t seed) {
    RandomChoice random(seed);
    WorkBudget budget({1e8});
    const auto code = find_free_code(24, 2, 8, random, budget);
    return std::vector<Codeword>(code->basis().begin(), code->basis().end());
  };
  EXPECT_EQ(found(6), found(6));
  EXPECT_NE(found(6), found(7));
}

}  // namespace
}  // namespace tagmint::codec
