#include "search/linear_programming_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace tagmint::codec {
namespace {

std::uint64_t bound(int bits, int distance) {
  return static_cast<std::uint64_t>(
      linear_programming_bound(bits, distance, ConstantWeightBounds(bits, distance)));
}

/// At most what Delsarte's inequalities alone give, and at least what is proven to be true of A(n,
/// d) by stronger means: the table of A. Schrijver: New code upper bounds from the Terwilliger
/// algebra and semidefinite programming, IEEE Transactions on Information Theory 51(8), 2005.
TEST(LinearProgrammingBound, IsNoWorseThanThePublishedOne) {
  struct Row {
    int bits, distance;
    std::uint64_t semidefinite, delsarte;
  };
  for (const Row& row : {Row{19, 6, 1280, 1289}, Row{23, 6, 13766, 13775}, Row{20, 8, 274, 290},
                         Row{25, 8, 5477, 6474}, Row{27, 8, 17768, 18189}, Row{22, 10, 87, 95},
                         Row{25, 10, 503, 551}, Row{26, 10, 886, 1040}}) {
    EXPECT_LE(bound(row.bits, row.distance), row.delsarte) << row.bits << ' ' << row.distance;
    EXPECT_GE(bound(row.bits, row.distance), row.semidefinite) << row.bits << ' ' << row.distance;
  }
  EXPECT_EQ(bound(19, 6), 1289U);
  EXPECT_EQ(bound(20, 8), 290U);
}

TEST(LinearProgrammingBound, IsReachedByTheGolayCode) { EXPECT_EQ(bound(24, 8), 4096U); }

/// Delsarte's inequalities imply the elementary bounds; Plotkin's beyond its rounding to even.
TEST(LinearProgrammingBound, ImpliesTheElementaryBounds) {
  for (int bits = 5; bits <= 48; ++bits) {
    for (int distance = 4; distance <= bits; distance += 2) {
      const WideCount elementary =
          std::min({singleton_bound(bits, distance), sphere_packing_bound(bits, distance),
                    plotkin_bound(bits, distance) + 1});
      EXPECT_LE(bound(bits, distance), static_cast<std::uint64_t>(elementary))
          << bits << ' ' << distance;
    }
  }
}

/// Where 57 of the 113 bits cancel.
TEST(LinearProgrammingBound, KeepsItsDigitsAtTheLargestNumbers) {
  const std::uint64_t packed = std::uint64_t{1} << 57;  // the extended Hamming code
  EXPECT_GE(bound(64, 4), packed);
  EXPECT_LE(bound(64, 4) - packed, packed >> 40);
}

}  // namespace
}  // namespace tagmint::codec
