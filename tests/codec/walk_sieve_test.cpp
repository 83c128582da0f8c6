#include "search/walk_sieve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "search/distance_filter.h"
#include "search/sieve_kernels.h"
#include "search/turn_index.h"
#include "support/instruction_sets.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::with_every_instruction_set;

std::vector<Codeword> random_words(std::size_t count, int bits, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Codeword> words(count);
  for (Codeword& word : words) word = random() & low_mask(bits);
  return words;
}

std::vector<Codeword> turns_of(const std::vector<Codeword>& codes, int bits) {
  std::vector<Codeword> turns;
  for (const Codeword code : codes) {
    for (int turn = 0; turn < 4; ++turn) turns.push_back(rotate(code, bits, turn));
  }
  return turns;
}

/// What the sieve must find, by the plain filter.
std::vector<std::uint64_t> open_words_plainly(int bits, int min_hamming,
                                              const std::vector<Codeword>& turns, Codeword first,
                                              std::uint64_t count) {
  std::vector<std::uint64_t> open;
  std::vector<Codeword> words(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    words[i] = (first + i * Walk::kStep) & low_mask(bits);
  }
  TurnBlocks blocks;
  for (std::size_t i = 0; i < turns.size(); i += 4) {
    blocks.add(std::span(turns).subspan(i).first<4>());
  }
  std::vector<std::uint32_t> kept(count);
  const std::size_t kept_count = keep_distant_scalar(words, blocks, min_hamming, kept.data());
  return {kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(kept_count)};
}

struct Case {
  int bits;
  int min_hamming;
  std::size_t codes;
};
constexpr Case kCases[] = {
    {1, 1, 1},     {4, 2, 1},     {5, 1, 2},     {16, 5, 10},   {21, 7, 30},   {32, 9, 100},
    {33, 10, 100}, {36, 11, 400}, {41, 12, 300}, {48, 12, 900}, {48, 14, 300}, {52, 13, 900},
    {63, 22, 200}, {64, 24, 100}, {64, 1, 9},    {36, 36, 1},   {64, 64, 1}};

TEST(WalkSieve, FindsWhatThePlainFilterFinds) {
  WalkSieve::Scratch scratch;
  for (const auto& [bits, min_hamming, codes] : kCases) {
    const std::vector<Codeword> turns = turns_of(random_words(codes, bits, 1), bits);
    const Codeword first = random_words(1, bits, 2)[0];
    for (const std::uint64_t count : {0, 1, 17, 3000}) {
      const auto expected = open_words_plainly(bits, min_hamming, turns, first, count);
      for (const std::uint64_t stretch : {1, 100, 1 << 10, 1 << 14, 1 << 20}) {
        const WalkSieve sieve(bits, min_hamming, turns, stretch);
        EXPECT_EQ(sieve.open_words(first, count, scratch), expected)
            << bits << " bits, distance " << min_hamming << ", " << count << " words, stretch "
            << stretch;
      }
    }
  }
}

TEST(WalkSieve, FindsTheSameByEveryPlan) {
  constexpr int kBits = 36;
  const std::vector<Codeword> turns = turns_of(random_words(200, kBits, 3), kBits);
  const Codeword first = 12345;
  const auto expected = open_words_plainly(kBits, 11, turns, first, 5000);
  ASSERT_GT(expected.size(), 10u);
  WalkSieve::Scratch scratch;
  for (const int fine_bits : {0, 3, 4, 7, 11}) {
    for (const int coarse_bits : {0, 2, 7, 11}) {
      if (coarse_bits > fine_bits) continue;
      for (const int fine_weight : {0, 1, 3, 30}) {
        for (const int coarse_weight : {0, 2, 30}) {
          const SievePlan plan{fine_bits, fine_weight, coarse_bits, coarse_weight};
          const WalkSieve sieve(kBits, 11, turns, 3000, plan);
          EXPECT_EQ(sieve.open_words(first, 5000, scratch), expected)
              << fine_bits << " " << fine_weight << " " << coarse_bits << " " << coarse_weight;
        }
      }
    }
  }
}

TEST(WalkSieve, FindsTheSameWithEveryInstructionSet) {
  for (const auto& [bits, min_hamming, codes] : {Case{36, 11, 400}, {48, 12, 2000}}) {
    const std::vector<Codeword> turns = turns_of(random_words(codes, bits, 5), bits);
    const auto expected = open_words_plainly(bits, min_hamming, turns, 99, 4000);
    with_every_instruction_set([&, bits = bits, min_hamming = min_hamming] {
      WalkSieve::Scratch scratch;
      const WalkSieve sieve(bits, min_hamming, turns, 1 << 20);
      EXPECT_EQ(sieve.open_words(99, 4000, scratch), expected);
    });
  }
}

TEST(WalkSieve, PlansGroupsThatLeaveRoomForWords) {
  for (int bits = 1; bits <= 64; ++bits) {
    for (const int min_hamming : {1, bits / 3 + 1, bits}) {
      for (const std::size_t turns : {0, 4, 10'000, 1'000'000}) {
        for (const int log_stretch : {0, 10, 20, 32}) {
          const SievePlan plan =
              plan_sieve(bits, min_hamming, turns, std::uint64_t{1} << log_stretch);
          EXPECT_LE(0, plan.coarse_bits);
          EXPECT_LE(plan.coarse_bits, plan.fine_bits);
          EXPECT_LE(plan.fine_bits, std::min({bits, 24, std::max(0, log_stretch - 4)}));
        }
      }
    }
  }
}

TEST(WalkSieve, LeavesEveryWordOpenWithoutCodes) {
  WalkSieve::Scratch scratch;
  const WalkSieve sieve(48, 12, {}, 100);
  std::vector<std::uint64_t> all(300);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  EXPECT_EQ(sieve.open_words(7, 300, scratch), all);
}

TEST(WalkSieve, MeetsTheWordsOfASmallSpaceAgainAndAgain) {
  WalkSieve::Scratch scratch;
  const std::vector<Codeword> turns = turns_of({0x3}, 4);
  const auto expected = open_words_plainly(4, 2, turns, 5, 100);
  EXPECT_EQ(WalkSieve(4, 2, turns, 1000).open_words(5, 100, scratch), expected);
}

TEST(WalkSieve, FindsTheCodesOfAPublishedFamilyInItsWalk) {
  constexpr std::size_t kKnown = 2000;
  constexpr std::size_t kFound = 100;
  const SharedFamily family = find_family("tagCustom48h12");
  const std::span<const Codeword> codes = family->codewords();
  const int bits = family->layout().bits();
  const Order order{Order::Kind::AprilTag3};
  const Walk walk(family->layout(), order,
                  walk_seed(order, family->layout(), family->min_hamming(), Complexity{}));
  const WalkSieve sieve(bits, family->min_hamming(),
                        turns_of({codes.begin(), codes.begin() + kKnown}, bits), 1 << 16);
  WalkSieve::Scratch scratch;
  const std::uint64_t begin = walk.position_of(codes[kKnown]);
  const std::uint64_t end = walk.position_of(codes[kKnown + kFound]);
  const auto open = sieve.open_words(walk.visited(begin), end - begin, scratch);
  for (std::size_t id = kKnown; id < kKnown + kFound; ++id) {
    EXPECT_TRUE(std::binary_search(open.begin(), open.end(), walk.position_of(codes[id]) - begin))
        << id;
  }
}

TEST(SieveKernels, EveryInstructionSetGivesTheScalarAnswer) {
  with_every_instruction_set([] {
    for (const std::size_t count : {0, 1, 7, 8, 15, 16, 17, 63, 64, 65, 300}) {
      for (const std::size_t code_count : {0, 1, 15, 31, 33, 100}) {
        const auto words = random_words(count + sieve_kernels::kPadding, 40, 6);
        const auto codes = random_words(code_count, 40, 7);
        std::vector<std::uint64_t> kept64 = words;
        std::vector<std::uint64_t> expected64 = words;
        kept64.resize(sieve_kernels::keep_far(kept64.data(), count, codes.data(), code_count, 12));
        expected64.resize(
            sieve_kernels::keep_far_scalar(expected64.data(), count, codes.data(), code_count, 12));
        EXPECT_EQ(kept64, expected64) << count << " words, " << code_count << " codes";

        std::vector<std::uint32_t> kept(words.begin(), words.end());
        std::vector<std::uint32_t> expected = kept;
        const std::vector<std::uint32_t> uppers(codes.begin(), codes.end());
        kept.resize(sieve_kernels::keep_far(kept.data(), count, uppers.data(), code_count, 9));
        expected.resize(
            sieve_kernels::keep_far_scalar(expected.data(), count, uppers.data(), code_count, 9));
        EXPECT_EQ(kept, expected) << count << " words, " << code_count << " codes";
      }
    }
  });
}

TEST(SieveKernels, ProgressionsAreTheSameWithEveryInstructionSet) {
  with_every_instruction_set([] {
    for (const std::size_t count : {0, 1, 16, 100}) {
      for (const int bits : {1, 20, 31, 32}) {
        std::vector<std::uint32_t> filled(count + sieve_kernels::kPadding);
        std::vector<std::uint32_t> expected(count);
        sieve_kernels::fill_progression(0xfedcba98, 982451653, bits, count, filled.data());
        sieve_kernels::fill_progression_scalar(0xfedcba98, 982451653, bits, count, expected.data());
        filled.resize(count);
        EXPECT_EQ(filled, expected);
      }
    }
  });
}

TEST(SieveKernels, GatheredCellsAreTheSameWithEveryInstructionSet) {
  // Cells of 0, 40, 3 and 17 codes.
  const std::vector<std::uint32_t> starts{0, 0, 40, 43, 60};
  std::vector<std::uint32_t> codes(60 + sieve_kernels::kPadding);
  for (std::uint32_t i = 0; i < codes.size(); ++i) codes[i] = i;
  const std::vector<std::uint32_t> masks{3, 0, 1, 2};
  with_every_instruction_set([&] {
    std::vector<std::uint32_t> gathered(60 + sieve_kernels::kPadding);
    std::vector<std::uint32_t> expected(60);
    EXPECT_EQ(sieve_kernels::gather_cells_scalar(starts.data(), codes.data(), 1, masks.data(),
                                                 masks.size(), expected.data()),
              60u);
    EXPECT_EQ(sieve_kernels::gather_cells(starts.data(), codes.data(), 1, masks.data(),
                                          masks.size(), gathered.data()),
              60u);
    gathered.resize(60);
    EXPECT_EQ(gathered, expected);
    EXPECT_EQ(expected.front(), 40u) << "cell 1 ^ 3 comes first";
  });
}

TEST(TurnIndex, PutsTurnsThatAgreeInTheirLowBitsSideBySide) {
  const std::vector<Codeword> turns = random_words(1000, 30, 8);
  const TurnIndex index(30, 7, 3, turns);
  std::vector<Codeword> found;
  for (std::uint32_t coarse = 0; coarse < 8; ++coarse) {
    for (const Codeword turn : index.coarse_cell(coarse)) {
      EXPECT_EQ(turn & 7, coarse);
      found.push_back(turn);
    }
  }
  EXPECT_TRUE(std::is_permutation(found.begin(), found.end(), turns.begin(), turns.end()));
  for (const Codeword turn : turns) {
    const std::uint32_t cell = index.cell_of(turn);
    std::size_t hits = 0;
    for (std::uint32_t i = index.starts()[cell]; i < index.starts()[cell + 1]; ++i) {
      EXPECT_EQ(index.turns()[i] & low_mask(7), turn & low_mask(7));
      EXPECT_EQ(index.uppers()[i], index.turns()[i] >> 7);
      hits += index.turns()[i] == turn;
    }
    EXPECT_EQ(hits, 1u);
  }
}

TEST(TurnIndex, WordsOfAWeightAreAllThereAre) {
  EXPECT_EQ(words_of_weight(0, 0), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(words_of_weight(4, 2), (std::vector<std::uint32_t>{3, 5, 6, 9, 10, 12}));
  EXPECT_EQ(words_of_weight(20, 3).size(), 1140u);
  EXPECT_EQ(words_of_weight(31, 31), (std::vector<std::uint32_t>{0x7fffffff}));
}

}  // namespace
}  // namespace tagmint::codec
