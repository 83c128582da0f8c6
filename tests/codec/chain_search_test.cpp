#include "search/rotation/chain_search.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

/// Orbits of four different words, one by one.
std::size_t plain_tags(const TurnCode& code) {
  std::set<Codeword> least;
  for (const Codeword word : test::words_of(code)) {
    if (rotate(word, code.bits(), 2) != word) least.insert(test::least_turn(word, code.bits()));
  }
  return least.size();
}

/// Levels inside one another, each with a basis that begins with that of the one before, and with
/// the distances asked for.
void expect_valid(const CodeChain& chain, std::span<const int> distances) {
  ASSERT_EQ(chain.levels.size(), distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const CodeChain::Level& level = chain.levels[i];
    EXPECT_EQ(level.distance, distances[i]);
    EXPECT_TRUE(test::prefixes_are_closed(level.code));
    EXPECT_GE(test::plain_least_weight(level.code.basis()), distances[i]);
    if (i > 0) {
      EXPECT_TRUE(test::begins_with(level.code, chain.levels[i - 1].code));
    }
  }
}

TEST(TagsOf, AreTheOrbitsOfFourWords) {
  RandomChoice random(1);
  for (const int bits : {8, 12, 13, 20}) {
    for (int dimension = 0; dimension <= 8; ++dimension) {
      const TurnCode code = test::random_code(bits, dimension, random);
      EXPECT_EQ(tags_of(code), static_cast<double>(plain_tags(code)));
    }
  }
}

TEST(ValueOf, CountsTheWholeFamilyThreeTimesAndEmptyLevelsNot) {
  const TurnCode none(16);
  const TurnCode small = test::code_of(16, {0x8000});
  TurnCode large = small;
  large.adjoin(std::array<Codeword, 1>{0x4000});
  const double of_small = std::log2(tags_of(small));
  const double of_large = std::log2(tags_of(large));
  EXPECT_EQ(tags_of(small), 3);   // of 16 words 4 are kept by a half turn
  EXPECT_EQ(tags_of(large), 60);  // of 256 words 16
  EXPECT_DOUBLE_EQ(value_of({{{small, 1}}, ""}), 3 * of_small);
  EXPECT_DOUBLE_EQ(value_of({{{small, 1}, {large, 1}}, ""}), of_small + 3 * of_large);
  EXPECT_DOUBLE_EQ(value_of({{{none, 9}, {large, 1}}, ""}), 3 * of_large);
  // A level that adds nothing to the one before counts nothing, but the whole family does.
  EXPECT_DOUBLE_EQ(value_of({{{small, 2}, {small, 2}, {large, 1}}, ""}), of_small + 3 * of_large);
}

TEST(SearchChain, HasNestedCodesOfTheDistancesAskedFor) {
  constexpr std::array kDistances = {8, 6, 4};
  for (const bool vary : {false, true}) {
    RandomChoice random(2);
    const CodeChain chain = search_chain(16, kDistances, nullptr, vary, {1e6}, random);
    expect_valid(chain, kDistances);
    EXPECT_EQ(chain.construction, "quasi-cyclic search");
    // [16, 5, 8] and [16, 11, 4] are the best linear codes.
    EXPECT_LE(chain.levels.front().code.dimension(), 5);
    EXPECT_EQ(chain.levels.back().code.dimension(), 11) << (vary ? "with variation" : "");
  }
}

TEST(SearchChain, StaysWithinTheKnownCodes) {
  const std::vector<KnownChain> known = known_chains();
  constexpr std::array kDistances = {12, 8};
  for (const KnownChain& chain : known) {
    if (chain.bits != 24) continue;
    RandomChoice random(3);
    const CodeChain found = search_chain(24, kDistances, &chain, false, {1e6}, random);
    expect_valid(found, kDistances);
    EXPECT_EQ(found.construction, chain.name);
    EXPECT_TRUE(test::contains(chain.codes.back().code, found.levels.front().code));
    EXPECT_EQ(found.levels.back().code.dimension(), 12);
  }
}

TEST(SearchChainUpward, FindsTheWholeCodeFirst) {
  constexpr std::array kDistances = {12, 8};
  RandomChoice random(4);
  const CodeChain chain = search_chain_upward(24, kDistances, nullptr, {2e7}, random);
  expect_valid(chain, kDistances);
  EXPECT_EQ(chain.levels.back().code.dimension(), 12) << "Golay's code";
  EXPECT_GE(tags_of(chain.levels.front().code), 3);
}

TEST(SearchInside, LeavesOutDistancesWithoutATag) {
  RandomChoice random(5);
  WorkBudget budget({1e8});
  const TurnCode whole = test::code_of(16, {0x8b8b, 0x5d6e, 0x149f});
  ASSERT_GE(test::plain_least_weight(whole.basis()), 5);
  constexpr std::array kDistances = {16, 8, 6};
  const CodeChain chain = search_inside({whole, 5}, kDistances, {1e6}, random);
  ASSERT_GE(chain.levels.size(), 2u);
  EXPECT_NE(chain.levels.front().distance, 16) << "one word and 0 make no tag";
  EXPECT_EQ(chain.levels.back().distance, 5);
  EXPECT_EQ(chain.levels.back().code.dimension(), whole.dimension());
  for (const CodeChain::Level& level : chain.levels) {
    EXPECT_TRUE(test::contains(whole, level.code));
    EXPECT_GE(test::plain_least_weight(level.code.basis()), level.distance);
    EXPECT_GE(plain_tags(level.code), 1u);
  }
}

}  // namespace
}  // namespace tagmint::codec
