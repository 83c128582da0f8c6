#include "tagmint/codec/family_stats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "pair_distances.h"
#include "support/generated_families.h"
#include "support/rotation_codes.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

Family random_family(const Layout& layout, std::size_t codes, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Codeword> words;
  while (words.size() < codes) {
    const Codeword word = random() & low_mask(layout.bits());
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return Family({"random", layout, 1, words, {}, {}, {}});
}

TEST(FamilyStats, CountsEveryPairAndEveryTagOnce) {
  for (const char* layout : {"classic:8", "circle:9", "standard:10", "classic:12"}) {
    const Family family = random_family(parse_layout(layout), 203, 1);
    const int bits = family.bits();
    std::vector<std::uint64_t> pairs(bits + 1, 0);
    std::vector<std::uint64_t> selves(bits + 1, 0);
    for (TagId i = 0; i < family.size(); ++i) {
      ++selves[self_distance(family.codeword(i), bits)];
      for (TagId j = i + 1; j < family.size(); ++j) {
        ++pairs[rotation_distance(family.codeword(i), family.codeword(j), bits)];
      }
    }
    const FamilyStats stats = family_stats(family);
    EXPECT_EQ(stats.distance_histogram, pairs) << layout;
    EXPECT_EQ(stats.self_histogram, selves) << layout;
  }
}

TEST(FamilyStats, DoNotDependOnTheNumberOfThreads) {
  const Family family = random_family(classic_layout(9), 500, 2);
  const FamilyStats one = family_stats(family, 1);
  for (const int threads : {2, 3, 8}) {
    const FamilyStats many = family_stats(family, threads);
    EXPECT_EQ(many.distance_histogram, one.distance_histogram);
    EXPECT_EQ(many.self_histogram, one.self_histogram);
    EXPECT_EQ(many.min_hamming, one.min_hamming);
  }
}

TEST(FamilyStats, PublishedFamiliesKeepTheirDistance) {
  for (const char* name : {"tag16h5", "tag25h9", "tag36h11", "tag36h10", "tag36h9", "tagCircle21h7",
                           "tagStandard41h12"}) {
    const SharedFamily family = find_family(name);
    const FamilyStats stats = family_stats(*family);
    EXPECT_EQ(stats.min_hamming, family->min_hamming()) << name;
    const std::uint64_t n = family->size();
    EXPECT_EQ(std::accumulate(stats.distance_histogram.begin(), stats.distance_histogram.end(),
                              std::uint64_t{0}),
              n * (n - 1) / 2);
  }
}

TEST(FamilyStats, TheFalseAcceptRateCountsTheWordsThatWouldBeAccepted) {
  const SharedFamily family = find_family("tag16h5");
  const FamilyStats stats = family_stats(*family);
  ASSERT_EQ(stats.false_accept_rate.size(), 9u);
  for (int radius = 0; radius <= family->max_safe_errors(); ++radius) {
    int accepted = 0;
    for (Codeword word = 0; word < 0x10000; ++word) {
      accepted += std::any_of(
          family->codewords().begin(), family->codewords().end(),
          [&](Codeword codeword) { return rotation_distance(word, codeword, 16) <= radius; });
    }
    EXPECT_DOUBLE_EQ(stats.false_accept_rate[radius], accepted / 65536.0) << radius;
  }
  EXPECT_EQ(stats.false_accept_rate.back(), 1.0);
}

TEST(FamilyStats, ThePaperGivesTheSameFalseAcceptRate) {
  // [WangOlson2016] states 0.000570 % for 36h11 with up to two errors; that is one rotation's
  // worth.
  const FamilyStats stats = family_stats(*find_family("tag36h11"));
  EXPECT_NEAR(stats.false_accept_rate[2] / 4, 0.00000570, 0.000000005);
}

TEST(FamilyStats, ASingleTagHasItsSelfDistance) {
  const FamilyStats stats =
      family_stats(Family({"one", classic_layout(8), 1, {0x000f}, {}, {}, {}}));
  EXPECT_EQ(stats.min_hamming, 8);
  EXPECT_EQ(std::accumulate(stats.distance_histogram.begin(), stats.distance_histogram.end(), 0u),
            0u);
}

TEST(FamilyStats, TellTheFiguresOfEachLevel) {
  FamilyParts parts = test::generated_36();
  RotationCodeParts code = test::chain_of_36_bits();
  code.basis.resize(15);
  code.levels.resize(3);
  parts.generator = std::make_shared<const RotationCode>(code);
  parts.levels.resize(3);
  parts.min_hamming = 10;
  const Family family(parts);
  const FamilyStats generated = family_stats(family);
  const std::vector<LevelStats> expected = {{60, 16, 60}, {2016, 12, 1884}, {8128, 10, 7531}};
  EXPECT_EQ(generated.levels, expected);
  EXPECT_EQ(generated.min_hamming, 10);
  EXPECT_TRUE(generated.distance_histogram.empty());

  const FamilyStats listed = family_stats(test::listed(family));
  EXPECT_EQ(listed.levels, expected);
  EXPECT_EQ(listed.min_hamming, 10);
  EXPECT_EQ(listed.self_histogram, generated.self_histogram);
  EXPECT_EQ(listed.false_accept_rate, generated.false_accept_rate);
  EXPECT_TRUE(listed.word_distances.empty());
}

TEST(FamilyStats, CountTheDistancesBetweenWordsOfGeneratedFamilies) {
  for (const FamilyParts& parts : {test::generated_16(), test::generated_25()}) {
    const Family family(parts);
    const int bits = family.bits();
    // No word of these codes is fixed by a half turn: each is a turn of a tag.
    std::vector<Codeword> words;
    for (const Codeword tag : first_codewords(family, family.size())) {
      for (int turn = 0; turn < 4; ++turn) words.push_back(rotate(tag, bits, turn));
    }
    std::vector<double> seen(bits + 1, 0);
    for (const Codeword a : words) {
      for (const Codeword b : words) seen[hamming_distance(a, b)] += 1.0 / words.size();
    }
    const FamilyStats stats = family_stats(family);
    ASSERT_EQ(stats.word_distances.size(), seen.size());
    for (int distance = 0; distance <= bits; ++distance) {
      EXPECT_NEAR(stats.word_distances[distance], seen[distance], 1e-9) << distance;
    }
    EXPECT_EQ(stats.levels.size(), family.levels().size());
  }
}

TEST(PairDistances, AreCountedByLevel) {
  const Family family = random_family(classic_layout(8), 100, 3);
  const std::vector<Level> levels = {{1, 9}, {10, 8}, {60, 7}, {100, 6}};
  const auto histograms = pair_histograms(family.codewords(), 16, levels, 2);
  ASSERT_EQ(histograms.size(), 4u);
  std::uint64_t pairs_so_far = 0;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    pairs_so_far +=
        std::accumulate(histograms[level].begin(), histograms[level].end(), std::uint64_t{0});
    EXPECT_EQ(pairs_so_far, levels[level].codes * (levels[level].codes - 1) / 2);
  }
}

TEST(PairDistances, TheFirstNearPairHasTheLowestIds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Family family = random_family(classic_layout(9), 150, seed);
    const std::vector<Level> levels = {{40, 4}, {150, 2}};
    std::optional<std::pair<TagId, TagId>> expected;
    for (TagId i = 0; i < 150 && !expected; ++i) {
      for (TagId j = i + 1; j < 150 && !expected; ++j) {
        const int least = j < 40 ? 4 : 2;
        if (rotation_distance(family.codeword(i), family.codeword(j), 25) < least)
          expected = {i, j};
      }
    }
    for (const int threads : {1, 4}) {
      EXPECT_EQ(first_near_pair(family.codewords(), 25, levels, threads), expected) << seed;
    }
  }
}

}  // namespace
}  // namespace tagmint::codec
