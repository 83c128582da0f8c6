#include "search/paint_radius.h"

#include <gtest/gtest.h>

namespace tagmint::codec {
namespace {

TEST(PaintPlan, DeepBallsReachOneRowFarther) {
  const PaintPlan plan{.paint_radius = 3, .deep_radius = 5};
  EXPECT_EQ(plan.depth(3), 0) << "the centre's row";
  EXPECT_EQ(plan.depth(4), 1);
  EXPECT_EQ(plan.depth(5), 3);
  EXPECT_EQ(plan.depth(40), LeafPainter::kMostDepth);
  const PaintPlan all{.paint_radius = 0, .deep_radius = 0};
  EXPECT_EQ(all.depth(0), 0) << "there are no balls of radius -1";
  EXPECT_EQ(all.depth(2), 2);
}

TEST(PaintPlan, IsWithinItsLimits) {
  for (const int bits : {16, 17, 21, 36, 48, 61}) {
    for (int radius = 0; radius < bits; radius += 5) {
      for (const std::size_t turns : {0, 4, 100000}) {
        const int paint_radius = best_paint_radius(bits, radius, turns);
        EXPECT_GE(paint_radius, 0);
        EXPECT_LE(paint_radius, radius);
        const PaintPlan plan = best_paint_plan(bits, radius, turns, paint_radius);
        EXPECT_EQ(plan.paint_radius, paint_radius);
        EXPECT_GE(plan.deep_radius, paint_radius);
      }
    }
  }
}

TEST(PaintPlan, PaintsSmallerBallsWhereCodesAreFew) {
  EXPECT_LT(best_paint_radius(48, 11, 4 * 1000), best_paint_radius(48, 11, 4 * 40000));
}

}  // namespace
}  // namespace tagmint::codec
