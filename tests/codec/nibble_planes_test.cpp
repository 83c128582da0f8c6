#include "kernels/nibble_planes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "pair_distances.h"
#include "support/instruction_sets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

std::vector<Codeword> random_words(std::size_t count, int bits, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Codeword> words(count);
  for (Codeword& word : words) word = random() & low_mask(bits);
  return words;
}

TEST(NibblePlanes, HoldTheNibblesOfEachWord) {
  const std::vector<Codeword> words = random_words(200, 25, 1);
  const NibblePlanes planes(words, 25);
  EXPECT_EQ(planes.blocks(), 3U);
  EXPECT_EQ(planes.nibbles(), 7);
  for (std::size_t i = 0; i < planes.blocks() * NibblePlanes::kBlockWords; ++i) {
    Codeword word = 0;
    for (int k = 0; k < planes.nibbles(); ++k) {
      word = word << 4 | planes.block(i / 64)[static_cast<std::size_t>(k) * 64 + i % 64];
    }
    EXPECT_EQ(word, words[i]);
  }
}

TEST(NibblePlanes, DistancesAreThoseOfTheWords) {
  testing::with_every_instruction_set([] {
    for (const int bits : {4, 5, 16, 25, 36, 49, 52, 64}) {
      const std::vector<Codeword> words = random_words(64 * 37 + 5, bits, 2);
      const NibblePlanes planes(words, bits);
      ASSERT_EQ(planes.blocks(), 37U);
      for (const auto& [first, end] :
           {std::pair<std::size_t, std::size_t>{0, 37}, {0, 0}, {5, 6}, {3, 19}, {20, 37}}) {
        const FourTurns turns = four_turns(words[7], bits);
        DistanceHistogram found{};
        DistanceHistogram expected{};
        add_block_distances(planes, first, end, turns, found);
        scalar::add_distances(std::span(words).subspan(first * 64, (end - first) * 64), turns,
                              expected);
        EXPECT_EQ(found, expected) << bits << " bits, blocks " << first << " to " << end;
      }
    }
  });
}

TEST(NibblePlanes, ExtremeDistancesAreCounted) {
  testing::with_every_instruction_set([] {
    // All bits differ, and none.
    std::vector<Codeword> words(64 * 16, ~Codeword{0});
    words[1000] = 0;
    const NibblePlanes planes(words, 64);
    DistanceHistogram found{};
    add_block_distances(planes, 0, planes.blocks(), four_turns(0, 64), found);
    EXPECT_EQ(found[64], 64U * 16 - 1);
    EXPECT_EQ(found[0], 1U);
  });
}

TEST(PairDistances, OfManyBlocksAndLevelsAreThoseOfEachPair) {
  const int bits = 25;
  const std::vector<Codeword> words = random_words(2500, bits, 3);
  const std::vector<Level> levels = {{70, 1, 0}, {1100, 1, 0}, {2500, 1, 0}};
  std::vector<DistanceHistogram> expected(levels.size(), DistanceHistogram{});
  for (std::size_t j = 1; j < words.size(); ++j) {
    const std::size_t level = j < 70 ? 0 : j < 1100 ? 1 : 2;
    scalar::add_distances(std::span(words).first(j), four_turns(words[j], bits), expected[level]);
  }
  for (const int threads : {1, 3}) {
    EXPECT_EQ(pair_histograms(words, bits, levels, threads), expected);
  }
}

}  // namespace
}  // namespace tagmint::codec
