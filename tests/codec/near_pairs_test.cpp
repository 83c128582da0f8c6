#include "tagmint/codec/near_pairs.h"

#include <gtest/gtest.h>

#include <vector>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// By comparing all pairs one by one.
std::vector<NearPair> plainly(const Family& family, int within) {
  const int bits = family.bits();
  std::vector<NearPair> pairs;
  for (TagId a = 0; a < family.size(); ++a) {
    for (TagId b = a + 1; b < family.size(); ++b) {
      const int distance = rotation_distance(family.codeword(a), family.codeword(b), bits);
      if (distance <= within) pairs.push_back({a, b, distance, 0});
    }
  }
  return pairs;
}

TEST(NearPairs, AreThoseOfAllPairsThatAreNear) {
  for (const char* name : {"tag16h5", "tag36h11", "tagStandard41h12"}) {
    const SharedFamily family = find_family(name);
    const int within = family->min_hamming() + 1;
    std::vector<NearPair> expected = plainly(*family, within);
    std::vector<NearPair> found = near_pairs(*family, within, expected.size() + 1);
    ASSERT_EQ(found.size(), expected.size()) << name;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const int turned = hamming_distance(
          family->codeword(found[i].first),
          rotate(family->codeword(found[i].second), family->bits(), found[i].turns));
      EXPECT_EQ(turned, found[i].distance) << name << " pair " << i;
      found[i].turns = 0;
    }
    EXPECT_EQ(found, expected) << name;
  }
}

TEST(NearPairs, AreAsManyAsTheHistogramCounts) {
  const SharedFamily family = find_family("tag36h10");
  const FamilyStats stats = family_stats(*family);
  EXPECT_EQ(near_pairs(*family, 10, 1'000'000).size(), stats.distance_histogram[10]);
}

TEST(NearPairs, AreCutAfterTheFirstOnes) {
  const SharedFamily family = find_family("tag36h11");
  const std::vector<NearPair> all = near_pairs(*family, 11, 1'000'000);
  for (const std::size_t most : {0, 1, 7, 100}) {
    for (const int threads : {1, 3}) {
      EXPECT_EQ(
          near_pairs(*family, 11, most, threads),
          std::vector<NearPair>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(most)));
    }
  }
  EXPECT_TRUE(near_pairs(*family, 10, 5).empty());
}

}  // namespace
}  // namespace tagmint::codec
