#include "information_blocks.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <vector>

#include "support/fixed_random.h"

namespace tagmint::codec {
namespace {

/// `dimension` independent words of `bits` bits.
std::vector<Codeword> random_basis(int bits, int dimension, std::uint64_t seed) {
  testing::FixedRandom random(seed);
  std::vector<Codeword> basis;
  for (int i = 0; i < dimension; ++i) {
    // An own bit makes each independent of the others; the sums below it mix the bits.
    basis.push_back((random.bits() & low_mask(bits - dimension)) << dimension | Codeword{1} << i);
  }
  for (int i = 1; i < dimension; ++i) basis[i] ^= basis[random.bits() % static_cast<unsigned>(i)];
  return basis;
}

std::vector<int> all_positions(int bits) {
  std::vector<int> positions(static_cast<std::size_t>(bits));
  std::iota(positions.begin(), positions.end(), 0);
  return positions;
}

TEST(InformationBlocks, ColumnsAreSystematicAndTheKernelIsZeroInTheBlock) {
  const std::vector<Codeword> basis = random_basis(40, 12, 1);
  for (const int first : {0, 5, 31, 35}) {  // the last two have fewer bits than the basis words
    std::vector<int> positions;
    for (int position = first; position < 40; ++position) positions.push_back(position);
    const InformationBlock block = make_block(basis, positions);
    ASSERT_EQ(block.positions.size(), block.columns.size());
    ASSERT_EQ(block.columns.size() + block.kernel.size(), basis.size());
    for (std::size_t i = 0; i < block.positions.size(); ++i) {
      for (std::size_t j = 0; j < block.columns.size(); ++j) {
        EXPECT_EQ(block.columns[j] >> block.positions[i] & 1, i == j ? 1U : 0U);
      }
      for (const Codeword word : block.kernel) EXPECT_EQ(word >> block.positions[i] & 1, 0U);
    }
  }
}

TEST(InformationBlocks, PositionsThatDependOnOthersAreLeftOut) {
  // Bit 2 is the sum of bits 0 and 1; bit 3 is always zero.
  const InformationBlock block =
      make_block(std::vector<Codeword>{0b0101, 0b0110}, all_positions(4));
  EXPECT_EQ(block.positions, (std::vector<int>{0, 1}));
  EXPECT_EQ(block.columns, (std::vector<Codeword>{0b0101, 0b0110}));
  EXPECT_TRUE(block.kernel.empty());
}

TEST(InformationBlocks, AWordWithFewErrorsHasFewInSomeBlock) {
  for (const int dimension : {1, 5, 8, 13, 20, 30}) {
    const std::vector<Codeword> basis = random_basis(40, dimension, 2);
    for (int radius = 0; radius <= 40; ++radius) {
      const std::vector<BlockSearch> plan = plan_search(basis, 40, 1, radius);
      Codeword used = 0;
      int served = 0;
      for (const BlockSearch& search : plan) {
        for (const int position : search.block.positions) {
          const Codeword bit = Codeword{1} << position;
          EXPECT_EQ(used & bit, 0U) << "blocks share no position";
          used |= bit;
        }
        served += search.errors + 1;
      }
      const bool everything = plan.size() == 1 && plan.front().block.positions.empty();
      EXPECT_TRUE(everything || served >= radius + 1) << dimension << " " << radius;
    }
  }
}

TEST(InformationBlocks, TwoInformationSetsAndTwoErrorsNeed26Candidates) {
  // (I | R) with R invertible: the first half and the second are information sets.
  std::vector<Codeword> basis;
  for (int i = 0; i < 24; ++i)
    basis.push_back(Codeword{1} << i | (Codeword{3} << (24 + i) & low_mask(48)));
  const std::vector<BlockSearch> plan = plan_search(basis, 48, 1, 2);
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_EQ(count_candidates(plan[0]) + count_candidates(plan[1]), 26);
}

TEST(InformationBlocks, LargeRadiiTakeAllSums) {
  const std::vector<BlockSearch> plan = plan_search(random_basis(40, 10, 3), 40, 1, 40);
  ASSERT_EQ(plan.size(), 1U);
  EXPECT_TRUE(plan.front().block.positions.empty());
  EXPECT_EQ(count_candidates(plan.front()), 1024);
}

}  // namespace
}  // namespace tagmint::codec
