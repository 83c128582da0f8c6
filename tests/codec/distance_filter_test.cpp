#include "search/distance_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "search/turn_blocks.h"
#include "support/instruction_sets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

constexpr int kBits = 36;

std::array<Codeword, 4> turns_of(Codeword word) {
  std::array<Codeword, 4> turns;
  for (int turn = 0; turn < 4; ++turn) turns[turn] = rotate(word, kBits, turn);
  return turns;
}

std::vector<Codeword> random_words(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Codeword> words(count);
  for (Codeword& word : words) word = random() & low_mask(kBits);
  return words;
}

/// The indices kept by one of the two functions.
template <typename Filter>
std::vector<std::uint32_t> kept_by(Filter filter, const std::vector<Codeword>& words,
                                   TurnBlocks& blocks, int min_hamming) {
  std::vector<std::uint32_t> kept(words.size());
  kept.resize(filter(words, blocks, min_hamming, kept.data()));
  return kept;
}

TEST(DistanceFilter, KeepsWhatIsFarFromAllTurnsOfAllCodes) {
  const std::vector<Codeword> codes = random_words(9, 1);
  const std::vector<Codeword> words = random_words(2000, 2);
  for (const int min_hamming : {1, 8, 11, 14}) {
    TurnBlocks blocks;
    for (const Codeword code : codes) blocks.add(turns_of(code));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < words.size(); ++i) {
      int nearest = kBits;
      for (const Codeword code : codes) {
        nearest = std::min(nearest, rotation_distance(words[i], code, kBits));
      }
      if (nearest >= min_hamming) expected.push_back(i);
    }
    // Twice: the first pass has changed the order of the blocks.
    EXPECT_EQ(kept_by(keep_distant_scalar, words, blocks, min_hamming), expected) << min_hamming;
    EXPECT_EQ(kept_by(keep_distant_scalar, words, blocks, min_hamming), expected) << min_hamming;
  }
}

TEST(DistanceFilter, EveryInstructionSetGivesTheScalarAnswer) {
  tagmint::testing::with_every_instruction_set([] {
    for (const std::size_t code_count : {0, 1, 2, 3, 64, 65}) {
      TurnBlocks blocks;
      TurnBlocks scalar_blocks;
      for (const Codeword code : random_words(code_count, 3)) {
        blocks.add(turns_of(code));
        scalar_blocks.add(turns_of(code));
      }
      for (const std::size_t word_count : {0, 1, 7, 500}) {
        const std::vector<Codeword> words = random_words(word_count, 4);
        EXPECT_EQ(kept_by(keep_distant, words, blocks, 11),
                  kept_by(keep_distant_scalar, words, scalar_blocks, 11))
            << code_count << " codes";
      }
    }
  });
}

TEST(DistanceFilter, CodesAddedAfterBlocksMovedCount) {
  TurnBlocks blocks;
  std::vector<Codeword> codes = random_words(31, 5);
  const std::vector<Codeword> words = random_words(300, 6);
  for (const Codeword code : codes) {
    blocks.add(turns_of(code));
    kept_by(keep_distant, words, blocks, 12);
    EXPECT_TRUE(kept_by(keep_distant, {code}, blocks, 1).empty());
  }
  for (const Codeword code : codes) {
    EXPECT_TRUE(kept_by(keep_distant, {code}, blocks, 1).empty());
  }
  EXPECT_EQ(blocks.size(), 16u);
  EXPECT_EQ(blocks.full(), 15u);
}

}  // namespace
}  // namespace tagmint::codec
