#include "tagmint/codec/search/size_bound.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "search/best_word_bound.h"
#include "search/linear_programming_bound.h"
#include "search/published_bounds.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {
namespace {

std::uint64_t words(int bits, int distance) {
  return static_cast<std::uint64_t>(best_word_bound(bits, distance).words);
}

TEST(SizeBound, IsReachedByWellKnownCodes) {
  EXPECT_EQ(words(24, 8), 4096U);
  EXPECT_EQ(words(23, 7), 4096U);
  EXPECT_EQ(words(20, 8), 256U);
  EXPECT_EQ(words(16, 6), 256U);
  EXPECT_EQ(words(15, 5), 256U);
  EXPECT_EQ(words(8, 4), 16U);
  EXPECT_EQ(words(7, 3), 16U);
  EXPECT_EQ(words(63, 3), std::uint64_t{1} << 57);
}

TEST(SizeBound, IsExactAtTheSmallestAndLargestDistances) {
  for (int bits = 2; bits < 64; ++bits) {
    EXPECT_EQ(words(bits, 1), std::uint64_t{1} << bits);
    EXPECT_EQ(words(bits, 2), std::uint64_t{1} << (bits - 1));
    for (int distance = 2 * bits / 3 + 1; distance <= bits; ++distance) {
      EXPECT_EQ(words(bits, distance), 2U) << bits << ' ' << distance;
    }
    EXPECT_EQ(words(bits, bits + 1), 1U);
  }
}

/// A(n, d) where it is known, n from 6, 8 and 12 on: [MacWilliamsSloane1977], appendix A, with the
/// values proven since then.
TEST(SizeBound, IsNeverBelowTheTrueSize) {
  struct Row {
    int distance, first_bits;
    std::vector<std::uint64_t> sizes;
  };
  for (const Row& row : {Row{4, 6, {4, 8, 16, 20, 40, 72, 144, 256, 512, 1024, 2048}},
                         Row{6, 8, {2, 4, 6, 12, 24, 32, 64, 128, 256}},
                         Row{8, 12, {4, 4, 8, 16, 32, 36, 64, 128, 256, 512, 1024, 2048, 4096}}}) {
    int bits = row.first_bits;
    for (const std::uint64_t size : row.sizes) {
      EXPECT_GE(words(bits, row.distance), size) << bits << ' ' << row.distance;
      EXPECT_GE(words(bits - 1, row.distance - 1), size) << bits - 1 << ' ' << row.distance - 1;
      ++bits;
    }
  }
}

/// Tags of families that were found, as in docs/rotation-codes.md.
TEST(SizeBound, IsNeverBelowACodeThatWasFound) {
  struct Found {
    int bits, distance;
    double tags;
  };
  constexpr std::array kFound = {
      Found{16, 6, 60},     Found{21, 7, 136},      Found{24, 8, 1008},    Found{25, 7, 1008},
      Found{25, 9, 64},     Found{36, 8, 262144},   Found{36, 10, 16320},  Found{36, 12, 2016},
      Found{36, 14, 120},   Found{36, 16, 60},      Found{41, 12, 16437},  Found{41, 13, 1008},
      Found{41, 16, 240},   Found{48, 12, 4193280}, Found{48, 13, 32640},  Found{48, 16, 16320},
      Found{48, 20, 240},   Found{48, 24, 6},       Found{52, 10, 33.5e6}, Found{52, 12, 4194304},
      Found{52, 14, 65280}, Found{52, 16, 16384},   Found{52, 24, 24},     Found{64, 16, 4177920},
      Found{64, 22, 65280}, Found{64, 24, 16128},   Found{64, 28, 240},    Found{64, 32, 16}};
  for (const Found& found : kFound) {
    for (int distance = found.distance; distance >= found.distance - 2; --distance) {
      EXPECT_GE(upper_bound_of_tags(found.bits, distance).tags, found.tags)
          << found.bits << ' ' << distance;
    }
  }
}

TEST(SizeBound, IsNeverBelowABundledFamily) {
  for (const std::string& name : family_names()) {
    const SharedFamily family = find_family(name);
    for (const Level& level : family->levels()) {
      const SizeBound bound = upper_bound_of_tags(family->layout().bits(), level.min_hamming);
      EXPECT_GE(bound.tags, static_cast<double>(level.codes)) << name << ' ' << level.min_hamming;
    }
  }
}

TEST(SizeBound, NamesItsSource) {
  EXPECT_EQ(upper_bound_of_tags(24, 8).tags, 1024);
  EXPECT_EQ(upper_bound_of_tags(24, 8).source, "sphere packing");
  EXPECT_EQ(upper_bound_of_tags(16, 6).tags, 64);
  EXPECT_EQ(upper_bound_of_tags(16, 6).source, "Johnson");
  EXPECT_EQ(upper_bound_of_tags(21, 7).tags, 256);
  EXPECT_EQ(upper_bound_of_tags(25, 9).tags, 209);
  EXPECT_EQ(upper_bound_of_tags(25, 9).source, "published semidefinite programming");
  EXPECT_EQ(upper_bound_of_tags(36, 11).tags, 16735);
  EXPECT_EQ(upper_bound_of_tags(36, 11).source, "linear programming");
  EXPECT_EQ(upper_bound_of_tags(28, 9).source,
            "2 times published semidefinite programming at 27 bits");
}

TEST(SizeBound, FindsNoRoomForATagBeyondTwoWords) {
  EXPECT_EQ(upper_bound_of_tags(36, 30).tags, 0);
  EXPECT_EQ(upper_bound_of_tags(36, 37).tags, 0);
  EXPECT_EQ(upper_bound_of_tags(1, 1).tags, 0);
}

TEST(SizeBound, RoundsUpBeyondTheWholeDoubles) {
  EXPECT_EQ(upper_bound_of_tags(64, 1).tags, std::ldexp(1.0, 62));
  for (int distance = 1; distance <= 9; ++distance) {
    const WideCount exact = best_word_bound(64, distance).words / 4;
    EXPECT_TRUE(static_cast<WideCount>(upper_bound_of_tags(64, distance).tags) >= exact);
  }
}

/// A mistyped number would stand out from what linear programming says, which it improves a little.
TEST(SizeBound, PublishedBoundsAreALittleBelowComputedOnes) {
  int found = 0;
  for (int bits = 8; bits <= 40; ++bits) {
    for (int distance = 2; distance < bits; distance += 2) {
      const auto published = published_bound(bits, distance);
      if (!published) continue;
      ++found;
      const WideCount computed =
          linear_programming_bound(bits, distance, ConstantWeightBounds(bits, distance));
      EXPECT_TRUE(published.value() < computed) << bits << ' ' << distance;
      EXPECT_TRUE(published.value() * 3 > computed * 2) << bits << ' ' << distance;
    }
  }
  EXPECT_EQ(found, 17);
}

TEST(SizeBound, RefusesWhatIsNoCode) {
  EXPECT_THROW(upper_bound_of_tags(0, 1), std::invalid_argument);
  EXPECT_THROW(upper_bound_of_tags(65, 1), std::invalid_argument);
  EXPECT_THROW(upper_bound_of_tags(36, 0), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::codec
