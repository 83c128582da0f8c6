#include "numerics/union_find.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/fixed_random.h"

namespace tagmint::detect {
namespace {

TEST(UnionFind, ANewElementIsASetOfItsOwn) {
  UnionFind sets;
  EXPECT_EQ(sets.add(3), 0u);
  EXPECT_EQ(sets.add(5), 1u);
  EXPECT_EQ(sets.find(0), 0u);
  EXPECT_EQ(sets.find(1), 1u);
  EXPECT_EQ(sets.weight(1), 5u);
}

TEST(UnionFind, TheHeavierSetKeepsItsRoot) {
  UnionFind sets;
  sets.add(3);
  sets.add(5);
  EXPECT_EQ(sets.unite(0, 1), 1u);
  EXPECT_EQ(sets.find(0), 1u);
  EXPECT_EQ(sets.weight(1), 8u);
}

TEST(UnionFind, UnitingTwiceChangesNothing) {
  UnionFind sets;
  sets.add();
  sets.add();
  const std::uint32_t root = sets.unite(0, 1);
  EXPECT_EQ(sets.unite(1, 0), root);
  EXPECT_EQ(sets.weight(root), 2u);
}

TEST(UnionFind, ClearForgetsAllSets) {
  UnionFind sets;
  sets.add();
  sets.add();
  sets.unite(0, 1);
  sets.clear();
  EXPECT_EQ(sets.size(), 0u);
  EXPECT_EQ(sets.add(), 0u);
  EXPECT_EQ(sets.weight(0), 1u);
}

TEST(UnionFind, AgreesWithRelabellingEveryElementOnRandomUnions) {
  testing::FixedRandom random(7);
  for (int round = 0; round < 20; ++round) {
    const int n = random.between(1, 60);
    UnionFind sets;
    std::vector<int> naive(n);
    for (int i = 0; i < n; ++i) naive[i] = static_cast<int>(sets.add());
    for (int k = 0; k < n; ++k) {
      const int a = random.between(0, n - 1), b = random.between(0, n - 1);
      sets.unite(a, b);
      const int from = naive[b], to = naive[a];
      std::replace(naive.begin(), naive.end(), from, to);
    }
    for (int i = 0; i < n; ++i) {
      EXPECT_EQ(sets.weight(sets.find(i)), std::count(naive.begin(), naive.end(), naive[i]));
      for (int j = 0; j < n; ++j) {
        EXPECT_EQ(sets.find(i) == sets.find(j), naive[i] == naive[j]);
      }
    }
  }
}

}  // namespace
}  // namespace tagmint::detect
