#include "kernels/hamming_kernels.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <random>
#include <vector>

#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

constexpr std::size_t kLongest = 67;  // twice four vectors of eight lanes, and some more

std::vector<Codeword> random_words(std::size_t count, int bits, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Codeword> words(count);
  for (Codeword& word : words) word = random() & low_mask(bits);
  return words;
}

/// Runs `test` once with each set of instructions that this machine has.
template <typename Test>
void with_every_target(const Test& test) {
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
    SCOPED_TRACE(hwy::TargetName(target));
    test();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

TEST(HammingKernels, FourTurnsAreTheTurnsOfRotation) {
  const FourTurns turns = four_turns(0x123456789abcdu, 49);
  for (int turn = 0; turn < 4; ++turn) EXPECT_EQ(turns[turn], rotate(0x123456789abcdu, 49, turn));
}

TEST(HammingKernels, FirstWithinEqualsTheScalarReferenceAtEveryLength) {
  with_every_target([] {
    std::mt19937_64 random(1);
    for (std::size_t length = 0; length <= kLongest; ++length) {
      for (const int bits : {4, 16, 36, 64}) {
        const std::vector<Codeword> words = random_words(length, bits, length);
        for (int radius = -1; radius <= bits; ++radius) {
          const Codeword probe = random() & low_mask(bits);
          EXPECT_EQ(first_within(words, probe, radius), scalar::first_within(words, probe, radius));
          const FourTurns turns = four_turns(probe, bits);
          EXPECT_EQ(first_within(words, turns, radius), scalar::first_within(words, turns, radius));
        }
      }
    }
  });
}

TEST(HammingKernels, FirstWithinFindsOneNearWordAtEveryPlace) {
  with_every_target([] {
    const Codeword probe = 0x5a5a5a5a5a5a5a5au;
    for (std::size_t length = 1; length <= kLongest; ++length) {
      std::vector<Codeword> words(length, ~probe);
      for (std::size_t place = 0; place < length; ++place) {
        words[place] = probe ^ 0x8000000000000001u;
        EXPECT_EQ(first_within(words, probe, 2), place);
        EXPECT_EQ(first_within(words, probe, 1), length);
        EXPECT_EQ(first_within(words, FourTurns{0, probe, ~Codeword{0}, 0xff}, 2), place);
        words[place] = ~probe;
      }
    }
  });
}

TEST(HammingKernels, AddDistancesEqualsTheScalarReference) {
  with_every_target([] {
    for (std::size_t length = 0; length <= kLongest; ++length) {
      for (const int bits : {1, 25, 52, 64}) {
        const std::vector<Codeword> words = random_words(length, bits, length + 100);
        const FourTurns turns = four_turns(0x9e3779b97f4a7c15u & low_mask(bits), bits);
        DistanceHistogram fast{};
        DistanceHistogram reference{};
        fast[3] = reference[3] = 7;  // what was there stays
        add_distances(words, turns, fast);
        scalar::add_distances(words, turns, reference);
        EXPECT_EQ(fast, reference);
        add_distances(words, turns[1], fast);
        scalar::add_distances(words, turns[1], reference);
        EXPECT_EQ(fast, reference);
      }
    }
  });
}

TEST(HammingKernels, TheLargestDistanceIsCounted) {
  with_every_target([] {
    const std::vector<Codeword> words(9, ~Codeword{0});
    DistanceHistogram histogram{};
    add_distances(words, FourTurns{0, 0, 0, 0}, histogram);
    EXPECT_EQ(histogram[64], 9u);
  });
}

}  // namespace
}  // namespace tagmint::codec
