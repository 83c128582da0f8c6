#include "search/word_bounds.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace tagmint::codec {
namespace {

/// Printable.
std::uint64_t narrow(WideCount count) { return static_cast<std::uint64_t>(count); }

TEST(WordBounds, BinomialsAreThoseOfPascal) {
  EXPECT_EQ(narrow(binomial(65, 32)), 3609714217008132870U);
  EXPECT_EQ(narrow(binomial(5, 2)), 10U);
  EXPECT_EQ(narrow(binomial(5, 6)), 0U);
  EXPECT_EQ(narrow(binomial(5, -1)), 0U);
}

TEST(WordBounds, SteinerSystemsReachTheConstantWeightBound) {
  EXPECT_EQ(narrow(ConstantWeightBounds(24, 8).at(24, 8)), 759U);  // the Golay code's octads
  EXPECT_EQ(narrow(ConstantWeightBounds(24, 8).at(23, 7)), 253U);
  EXPECT_EQ(narrow(ConstantWeightBounds(8, 4).at(8, 4)), 14U);
  EXPECT_EQ(narrow(ConstantWeightBounds(8, 4).at(7, 3)), 7U);     // lines of the Fano plane
  EXPECT_EQ(narrow(ConstantWeightBounds(16, 8).at(16, 8)), 30U);  // Reed and Muller's code
}

TEST(WordBounds, FewOnesLeaveRoomForOneWord) {
  const ConstantWeightBounds bounds(12, 8);
  for (const int weight : {0, 1, 2, 3, 9, 12}) EXPECT_EQ(narrow(bounds.at(12, weight)), 1U);
  EXPECT_EQ(narrow(bounds.at(12, 4)), 3U);
}

TEST(WordBounds, PerfectCodesReachTheSpherePackingBound) {
  EXPECT_EQ(narrow(sphere_packing_bound(24, 8)), 4096U);
  EXPECT_EQ(narrow(sphere_packing_bound(64, 4)), std::uint64_t{1} << 57);
}

TEST(WordBounds, NordstromAndRobinsonReachJohnsonsBound) {
  EXPECT_EQ(narrow(johnson_bound(16, 6, ConstantWeightBounds(16, 6))), 256U);
}

TEST(WordBounds, HadamardMatricesReachPlotkinsBound) {
  EXPECT_EQ(narrow(plotkin_bound(12, 6)), 24U);
  EXPECT_EQ(narrow(plotkin_bound(11, 6)), 12U);
  EXPECT_EQ(narrow(plotkin_bound(64, 32)), 128U);
}

}  // namespace
}  // namespace tagmint::codec
