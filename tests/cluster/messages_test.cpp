#include "cluster/messages.h"

#include <gtest/gtest.h>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::cluster {
namespace {

TEST(Messages, RulesSurviveTheirText) {
  using codec::Order;
  const codec::SearchRules rules[] = {
      {codec::parse_layout("classic:10"),
       11,
       {Order::Kind::AprilTag2, 0},
       {codec::ComplexityRule::Rectangles, 10}},
      {codec::parse_layout("standard:7"),
       9,
       {Order::Kind::Seed, -987654321987654321},
       {codec::ComplexityRule::Energy, 1.0 / 3}},
      {codec::parse_layout("circle:9"), 7, {}, {}},
  };
  for (const codec::SearchRules& expected : rules) {
    const codec::SearchRules read = parse_rules(rules_text(expected));
    EXPECT_EQ(read.layout, expected.layout);
    EXPECT_EQ(read.min_hamming, expected.min_hamming);
    EXPECT_EQ(read.order, expected.order);
    EXPECT_EQ(read.complexity, expected.complexity);
  }
}

}  // namespace
}  // namespace tagmint::cluster
