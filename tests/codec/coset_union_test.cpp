#include "search/rotation/coset_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

/// All words of all tags.
std::vector<Codeword> all_turns(const std::vector<Codeword>& tags, int bits) {
  std::vector<Codeword> words;
  for (const Codeword tag : tags) {
    for (int turn = 0; turn < 4; ++turn) words.push_back(rotate(tag, bits, turn));
  }
  std::sort(words.begin(), words.end());
  return words;
}

/// Whether the words are a union of cosets of `kernel`.
bool are_cosets(const std::vector<Codeword>& words, const TurnCode& kernel) {
  return std::all_of(words.begin(), words.end(), [&](Codeword word) {
    return std::all_of(kernel.rows().begin(), kernel.rows().end(), [&](Codeword row) {
      return std::binary_search(words.begin(), words.end(), word ^ row);
    });
  });
}

/// The most tags that fit among `candidates`, by trying all sets.
std::size_t most_tags(const std::vector<Codeword>& candidates, int bits, int distance) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    std::vector<Codeword> left;
    for (std::size_t j = i + 1; j < candidates.size(); ++j) {
      if (rotation_distance(candidates[i], candidates[j], bits) >= distance) {
        left.push_back(candidates[j]);
      }
    }
    most = std::max(most, 1 + most_tags(left, bits, distance));
  }
  return most;
}

std::vector<Codeword> possible_tags(int bits, int distance) {
  std::vector<Codeword> tags;
  for (Codeword word = 0; word < Codeword{1} << bits; ++word) {
    if (test::least_turn(word, bits) == word && self_distance(word, bits) >= distance) {
      tags.push_back(word);
    }
  }
  return tags;
}

TEST(CosetUnion, WithTheKernelZeroIsALargestSetOfTags) {
  for (const auto& [bits, distance] : {std::pair{8, 3}, {8, 4}, {9, 3}, {9, 4}, {12, 6}}) {
    RandomChoice random(1);
    WorkBudget budget({1e7});
    const std::vector<Codeword> tags = unite_cosets(TurnCode(bits), distance, random, budget);
    EXPECT_EQ(tags.size(), most_tags(possible_tags(bits, distance), bits, distance))
        << bits << " bits, distance " << distance;
    EXPECT_TRUE(test::are_apart(tags, bits, distance));
  }
}

TEST(CosetUnion, IsAUnionOfCosetsThatKeepsTheDistance) {
  // Kernels of 16 and 21 bits: docs/rotation-codes.md's codes hold them.
  const TurnCode of_16 = test::code_of(16, {0x5555, 0x8d8d});
  const TurnCode of_21 = test::code_of(21, {0xf7bde, 0x2689a, 0x6bc4});
  for (const auto& [kernel, distance] : {std::pair{of_16, 6}, {of_21, 7}}) {
    RandomChoice random(2);
    WorkBudget budget({2e7});
    const std::vector<Codeword> tags = unite_cosets(kernel, distance, random, budget);
    EXPECT_GT(tags.size(), 4u);
    EXPECT_TRUE(test::are_apart(tags, kernel.bits(), distance));
    EXPECT_TRUE(are_cosets(all_turns(tags, kernel.bits()), kernel));
  }
}

TEST(CosetUnion, IsEmptyWhereNoCosetKeepsTheDistance) {
  RandomChoice random(3);
  WorkBudget budget({1e6});
  // No word of eight bits differs from its half turn in more than eight places, of four in none.
  EXPECT_TRUE(unite_cosets(TurnCode(8), 9, random, budget).empty());
}

TEST(CosetUnion, IsTheSameForTheSameSeed) {
  const auto found = [](std::uint64_t seed) {
    RandomChoice random(seed);
    WorkBudget budget({2e6});
    return unite_cosets(TurnCode(12), 4, random, budget);
  };
  EXPECT_EQ(found(4), found(4));
  EXPECT_NE(found(4), found(5));
}

}  // namespace
}  // namespace tagmint::codec
