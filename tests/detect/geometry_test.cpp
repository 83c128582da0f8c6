#include "tagmint/detect/geometry.h"

#include <gtest/gtest.h>

namespace tagmint::detect {
namespace {

TEST(Geometry, TagCornersRunCounterClockwiseAsSeen) {
  EXPECT_DOUBLE_EQ(signed_area(kTagCorners), -4.0);
}

}  // namespace
}  // namespace tagmint::detect
