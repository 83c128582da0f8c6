#include "search/rotation/code_climb.h"

#include <gtest/gtest.h>

#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

std::vector<Codeword> basis_of(const TurnCode& code) {
  return {code.basis().begin(), code.basis().end()};
}

struct Case {
  int bits;
  WeightRule weights;
};

constexpr Case kCases[] = {{9, {3, 1}},  {13, {4, 1}}, {16, {5, 1}}, {16, {6, 2}},
                           {21, {7, 1}}, {24, {8, 4}}, {25, {9, 1}}};

TEST(Climb, ObeysTheRulesAndEndsWhereNothingMoreFits) {
  for (const Case& one : kCases) {
    RandomChoice random(1);
    WorkBudget budget({1e9});
    const TurnCode code = climb(TurnCode(one.bits), {.weights = one.weights}, random, budget);
    EXPECT_GT(code.dimension(), 0);
    EXPECT_TRUE(test::prefixes_are_closed(code));
    EXPECT_TRUE(test::has_weights(code, one.weights.at_least, one.weights.divisor));
    EXPECT_TRUE(far_extensions(code, nullptr, one.weights, budget).empty());
  }
}

TEST(Climb, BeginsWithItsStartStaysInsideAndEndsAtTheLargestDimension) {
  RandomChoice random(2);
  for (int i = 0; i < 10; ++i) {
    const TurnCode inside = test::random_code(20, 14, random);
    ClimbRules rules;
    rules.weights = {3, 1};
    rules.inside = &inside;
    rules.most_dimensions = 3;
    WorkBudget budget({1e9});
    const TurnCode start = climb(TurnCode(20), rules, random, budget);
    EXPECT_EQ(start.dimension(), 3);
    rules.most_dimensions = kMaxBits;
    const TurnCode code = climb(start, rules, random, budget);
    EXPECT_TRUE(test::begins_with(code, start));
    EXPECT_TRUE(test::contains(inside, code));
    EXPECT_TRUE(test::has_weights(code, 3, 1));
    EXPECT_TRUE(far_extensions(code, &inside, rules.weights, budget).empty());
  }
}

TEST(ClimbFar, ObeysTheRulesKeepsTheFloorAndIsNotSmallerThanItsStart) {
  for (const Case& one : kCases) {
    RandomChoice random(3);
    ClimbRules rules;
    rules.weights = one.weights;
    rules.most_dimensions = 2;
    WorkBudget short_climb({1e9});
    const TurnCode floor = climb(TurnCode(one.bits), rules, random, short_climb);
    rules.most_dimensions = kMaxBits;
    const TurnCode start = climb(floor, rules, random, short_climb);
    WorkBudget budget({2e6});
    const TurnCode code = climb_far(floor, start, rules, random, budget);
    EXPECT_TRUE(budget.is_spent());
    EXPECT_GE(code.dimension(), start.dimension());
    EXPECT_TRUE(test::begins_with(code, floor));
    EXPECT_TRUE(test::prefixes_are_closed(code));
    EXPECT_TRUE(test::has_weights(code, one.weights.at_least, one.weights.divisor));
  }
}

TEST(ClimbFar, StaysInsideAndEndsWithTheWholeOfIt) {
  RandomChoice random(4);
  const TurnCode inside = test::random_code(16, 6, random);
  ClimbRules rules;
  rules.inside = &inside;
  WorkBudget budget({1e9});
  const TurnCode code = climb_far(TurnCode(16), TurnCode(16), rules, random, budget);
  EXPECT_EQ(code.dimension(), 6);
  EXPECT_TRUE(test::contains(inside, code));
  EXPECT_FALSE(budget.is_spent());
}

TEST(ClimbFar, HasNothingToDoWhereTheFloorCannotGrow) {
  // All words of even weight cannot grow at distance 2.
  TurnCode even(8);
  even.adjoin(std::vector<Codeword>{3, 5, 9, 0x11});
  ASSERT_EQ(even.dimension(), 7);
  RandomChoice random(5);
  WorkBudget budget({1e9});
  EXPECT_EQ(climb_far(even, even, {.weights = {2, 1}}, random, budget).dimension(), 7);
  EXPECT_FALSE(budget.is_spent());
}

TEST(ClimbFar, IsTheSameForTheSameSeed) {
  const auto found = [](std::uint64_t seed) {
    RandomChoice random(seed);
    WorkBudget budget({1e6});
    return basis_of(climb_far(TurnCode(21), TurnCode(21), {.weights = {7, 1}}, random, budget));
  };
  EXPECT_EQ(found(6), found(6));
  EXPECT_NE(found(6), found(7));
}

TEST(ClimbFar, FindsGolaysCode) {
  RandomChoice random(8);
  WorkBudget budget({2e7});
  const TurnCode code = climb_far(TurnCode(24), TurnCode(24), {.weights = {8, 4}}, random, budget);
  EXPECT_EQ(code.dimension(), 12);
  EXPECT_EQ(test::plain_least_weight(code.basis()), 8);
}

}  // namespace
}  // namespace tagmint::codec
