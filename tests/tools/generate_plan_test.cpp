#include "cli/generate_plan.h"

#include <gtest/gtest.h>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

using codec::classic_layout;
using codec::Complexity;
using codec::ComplexityRule;
using codec::Order;

TEST(GeneratePlan, ClassicLayoutsTakeThePublishedThresholds) {
  const auto rectangles = [](int width) { return default_complexity(classic_layout(width)); };
  EXPECT_EQ(rectangles(8), (Complexity{ComplexityRule::Rectangles, 5}));
  EXPECT_EQ(rectangles(9), (Complexity{ComplexityRule::Rectangles, 8}));
  EXPECT_EQ(rectangles(10), (Complexity{ComplexityRule::Rectangles, 10}));
}

TEST(GeneratePlan, ThresholdsOfTheOtherSidesGoOnInAStraightLine) {
  const auto rectangles = [](int width) {
    return default_complexity(classic_layout(width)).threshold;
  };
  EXPECT_EQ(rectangles(5), 1);
  EXPECT_EQ(rectangles(6), 1);
  EXPECT_EQ(rectangles(7), 3);
  EXPECT_EQ(rectangles(11), 13);
  EXPECT_EQ(rectangles(12), 15);
}

TEST(GeneratePlan, OtherLayoutsTakeTheRulesOfAprilTag3) {
  for (const char* name : {"standard:7", "circle:9"}) {
    const codec::Layout layout = codec::parse_layout(name);
    EXPECT_EQ(default_order(layout).kind, Order::Kind::AprilTag3);
    EXPECT_EQ(default_complexity(layout), (Complexity{ComplexityRule::Energy, 0.3333}));
  }
  EXPECT_EQ(default_order(classic_layout(8)).kind, Order::Kind::AprilTag2);
}

TEST(GeneratePlan, LaterAttemptsTakeTheSeedsAfterTheFirst) {
  const codec::Layout layout = classic_layout(8);
  const Complexity complexity = default_complexity(layout);
  const Order published = default_order(layout);
  const auto orders = attempt_orders(published, layout, 5, complexity, 3);
  ASSERT_EQ(orders.size(), 3U);
  EXPECT_EQ(orders[0], published);
  EXPECT_EQ(orders[1], (Order{Order::Kind::Seed, 160506}));  // 16 * 10000 + 5 * 100 + 5, plus 1
  EXPECT_EQ(orders[2], (Order{Order::Kind::Seed, 160507}));
  EXPECT_EQ(attempt_orders({Order::Kind::Seed, 41}, layout, 5, complexity, 2)[1],
            (Order{Order::Kind::Seed, 42}));
}

}  // namespace
}  // namespace tagmint::cli
