#include "search/dense_simplex.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace tagmint::codec {
namespace {

/// The limits at these prices: the optimum when the prices are right.
double worth(const LinearProgram& program, const std::vector<Quad>& prices) {
  Quad sum = 0;
  for (std::size_t row = 0; row < prices.size(); ++row) sum += prices[row] * program.limits[row];
  return static_cast<double>(sum);
}

/// Whether no price is negative and each column's prices add up to its gain at least.
bool are_feasible(const LinearProgram& program, const std::vector<Quad>& prices) {
  constexpr double kRounding = 1e-20;
  for (const Quad price : prices) {
    if (price < 0) return false;
  }
  for (std::size_t column = 0; column < program.gains.size(); ++column) {
    Quad sum = -program.gains[column];
    for (std::size_t row = 0; row < prices.size(); ++row) {
      sum += prices[row] * program.matrix[row][column];
    }
    if (sum < -kRounding) return false;
  }
  return true;
}

TEST(DenseSimplex, PricesThePublishedExample) {
  // [Chvatal1983], page 13.
  const LinearProgram program = {
      .matrix = {{2, 3, 1}, {4, 1, 2}, {3, 4, 2}}, .limits = {5, 11, 8}, .gains = {5, 4, 3}};
  const std::vector<Quad> prices = dual_prices(program);
  EXPECT_TRUE(are_feasible(program, prices));
  EXPECT_DOUBLE_EQ(worth(program, prices), 13);
}

TEST(DenseSimplex, EndsWhereStepsGainNothing) {
  // The largest gain alone goes round in circles here: [Chvatal1983], page 31.
  const LinearProgram program = {
      .matrix = {{0.5, -5.5, -2.5, 9}, {0.5, -1.5, -0.5, 1}, {1, 0, 0, 0}},
      .limits = {0, 0, 1},
      .gains = {10, -57, -9, -24}};
  const std::vector<Quad> prices = dual_prices(program);
  EXPECT_TRUE(are_feasible(program, prices));
  EXPECT_DOUBLE_EQ(worth(program, prices), 1);
}

TEST(DenseSimplex, NothingToGainCostsNothing) {
  const LinearProgram program = {.matrix = {{1, 1}}, .limits = {7}, .gains = {-1, 0}};
  EXPECT_EQ(worth(program, dual_prices(program)), 0);
}

}  // namespace
}  // namespace tagmint::codec
