#include "search/rotation/extension_sieve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

/// The classes modulo `code`, by their least words, whose sums grow it to a closed code that still
/// obeys the rule; word by word.
std::set<Codeword> plain_far_extensions(const TurnCode& code, const TurnCode* inside,
                                        const WeightRule& rule) {
  std::set<Codeword> classes;
  for (Codeword word = 0; word < Codeword{1} << code.bits(); ++word) {
    if (code.reduce(word) != word || word == 0) continue;
    if (inside != nullptr && !inside->contains(word)) continue;
    if (!code.contains(turn_difference(word, code.bits()))) continue;
    TurnCode grown = code;
    grown.extend(word);
    if (test::has_weights(grown, rule.at_least, rule.divisor)) classes.insert(word);
  }
  return classes;
}

/// Compares on the way from nothing up to a code that cannot grow; returns how many ways it saw.
std::size_t compare_on_a_way_up(int bits, const TurnCode* inside, const WeightRule& rule,
                                RandomChoice& random) {
  std::size_t seen = 0;
  TurnCode code(bits);
  for (;;) {
    WorkBudget budget({1e9});
    const std::vector<Codeword> ways = far_extensions(code, inside, rule, budget);
    const std::set<Codeword> set(ways.begin(), ways.end());
    EXPECT_EQ(set.size(), ways.size());
    EXPECT_EQ(set, plain_far_extensions(code, inside, rule))
        << bits << " bits, dimension " << code.dimension() << ", weights from " << rule.at_least
        << ", divided by " << rule.divisor;
    seen += ways.size();
    if (ways.empty()) return seen;
    code.extend(random.of(ways));
  }
}

TEST(FarExtensions, AreThoseThatPlainEnumerationFinds) {
  RandomChoice random(1);
  for (const int bits : {4, 5, 8, 9}) {
    for (const int divisor : {1, 2, 4}) {
      for (int at_least = 1; at_least <= bits; ++at_least) {
        compare_on_a_way_up(bits, nullptr, {at_least, divisor}, random);
      }
    }
  }
}

TEST(FarExtensions, AreThoseThatPlainEnumerationFindsInMoreBits) {
  RandomChoice random(2);
  EXPECT_GT(compare_on_a_way_up(12, nullptr, {4, 4}, random), 0U);
  EXPECT_GT(compare_on_a_way_up(13, nullptr, {5, 1}, random), 0U);
  EXPECT_GT(compare_on_a_way_up(12, nullptr, {4, 2}, random), 0U);
}

TEST(FarExtensions, StayInsideTheCodeThatIsGiven) {
  RandomChoice random(3);
  for (const int bits : {9, 12}) {
    for (int dimension = 4; dimension < bits; dimension += 2) {
      const TurnCode inside = test::random_code(bits, dimension, random);
      compare_on_a_way_up(bits, &inside, {2, 1}, random);
      compare_on_a_way_up(bits, &inside, {4, 2}, random);
    }
  }
}

TEST(FarExtensions, TellWhatTheyCompareButDoNotEndWithTheBudget) {
  RandomChoice random(4);
  for (int dimension = 0; dimension <= 8; ++dimension) {
    const TurnCode code = test::random_code(24, dimension, random);
    WorkBudget little({1});
    WorkBudget enough({std::ldexp(1.0, dimension + 24 / 4 + 1) + 1});
    EXPECT_EQ(far_extensions(code, nullptr, {1, 1}, little),
              far_extensions(code, nullptr, {1, 1}, enough));
    EXPECT_TRUE(little.is_spent());
    EXPECT_FALSE(enough.is_spent());
  }
}

TEST(WorkBudget, EndsWithItsWordsOrWhenAskedToStop) {
  std::stop_source source;
  WorkBudget budget({10, source.get_token()});
  budget.spend(9);
  EXPECT_FALSE(budget.is_spent());
  WorkBudget copy = budget;
  copy.spend(1);
  EXPECT_TRUE(copy.is_spent());
  EXPECT_FALSE(budget.is_spent());
  source.request_stop();
  EXPECT_TRUE(budget.is_spent());
}

}  // namespace
}  // namespace tagmint::codec
