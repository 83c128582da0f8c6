#include "level_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "support/rotation_codes.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using Address = RotationCode::Address;

SharedRotationCode make_code(const RotationCodeParts& parts) {
  return std::make_shared<const RotationCode>(parts);
}

/// Codes with one coset and with several, with centre and without; the last has a single tag, and
/// half of its words are none.
std::vector<RotationCodeParts> small_codes() {
  RotationCodeParts small_36 = test::chain_of_36_bits();
  small_36.basis.resize(13);
  small_36.levels = {{8}, {13}};
  RotationCodeParts single = test::chain_of_16_bits();
  single.basis.resize(3);
  single.levels = {};
  return {test::chain_of_16_bits(),
          test::cosets_of_16_bits(),
          test::chain_of_25_bits(),
          test::coset_of_25_bits(),
          small_36,
          single};
}

TagIndex index_of(const SharedRotationCode& code) {
  const int bits = code->bits();
  return {code, classic_layout(bits == 16 ? 8 : bits == 25 ? 9 : 10), {}};
}

std::vector<Codeword> words_of_level(const RotationCode& code, std::size_t level) {
  std::vector<Codeword> words;
  const RotationCodeLevel& part = code.levels()[level];
  for (Address coset = 0; coset < part.cosets; ++coset) {
    for (Address message = 0; message < Address{1} << part.dimension; ++message) {
      words.push_back(code.word(coset << code.dimension() | message));
    }
  }
  return words;
}

TEST(LevelDistances, AreThoseBetweenAllWords) {
  for (const RotationCodeParts& parts : small_codes()) {
    const RotationCode code(parts);
    for (std::size_t level = 0; level < code.levels().size(); ++level) {
      const std::vector<Codeword> words = words_of_level(code, level);
      DistanceHistogram pairs{};  // seen from every word
      for (const Codeword word : words) scalar::add_distances(words, word, pairs);
      DistanceHistogram found = level_distances(code, level, 2);
      for (std::uint64_t& count : found) count <<= code.levels()[level].dimension;
      EXPECT_EQ(found, pairs) << code.bits() << ' ' << level;
    }
  }
}

TEST(LevelDistances, DoNotDependOnTheNumberOfThreads) {
  const RotationCode code(test::chain_of_36_bits());
  const DistanceHistogram one = level_distances(code, 3, 1);
  EXPECT_EQ(level_distances(code, 3, 3), one);
  EXPECT_EQ(level_distances(code, 3, 8), one);
}

TEST(LevelDistances, OfTagsAreThoseOfAllPairs) {
  for (const RotationCodeParts& parts : small_codes()) {
    const SharedRotationCode code = make_code(parts);
    const TagIndex index = index_of(code);
    for (std::size_t level = 0; level < code->levels().size(); ++level) {
      const std::vector<Codeword> tags = index.codewords(0, code->tags(level));
      int least = code->bits();
      for (std::size_t i = 0; i < tags.size(); ++i) {
        least = std::min(least, self_distance(tags[i], code->bits()));
        for (std::size_t j = 0; j < i; ++j) {
          least = std::min(least, rotation_distance(tags[i], tags[j], code->bits()));
        }
      }
      const DistanceHistogram distances = level_distances(*code, level, 1);
      EXPECT_EQ(tag_distance(index, level, distances, 1), least) << code->bits() << ' ' << level;
    }
  }
}

TEST(LevelDistances, NearTagsAreToldByTheirIds) {
  for (const RotationCodeParts& parts : small_codes()) {
    const SharedRotationCode code = make_code(parts);
    const TagIndex index = index_of(code);
    for (std::size_t level = 0; level < code->levels().size(); ++level) {
      const int distance = tag_distance(index, level, level_distances(*code, level, 1), 1);
      EXPECT_TRUE(near_tags(index, level, distance).empty());
      const std::vector<TagId> near = near_tags(index, level, distance + 1);
      ASSERT_FALSE(near.empty());
      EXPECT_LT(near.back(), code->tags(level));
      const Codeword a = index.codeword(near.front());
      if (near.size() == 1) {
        EXPECT_EQ(self_distance(a, code->bits()), distance);
      } else {
        EXPECT_LT(near[0], near[1]);
        EXPECT_EQ(rotation_distance(a, index.codeword(near[1]), code->bits()), distance);
      }
    }
  }
}

/// The figures of the chain of 48 bits, all 2^24 words of it.
TEST(LevelDistances, ServeLargeCodes) {
  const RotationCode code(test::chain_of_48_bits());
  std::vector<int> least;
  for (std::size_t level = 0; level < 4; ++level) {
    const DistanceHistogram distances = level_distances(code, level, 0);
    EXPECT_EQ(distances[0], 1u);
    const auto used =
        std::find_if(distances.begin() + 1, distances.end(), [](auto n) { return n > 0; });
    least.push_back(static_cast<int>(used - distances.begin()));
    std::uint64_t words = 0;
    for (const std::uint64_t count : distances) words += count;
    EXPECT_EQ(words, code.words(level));
    // The extended quadratic residue code is self-dual: all weights are multiples of four.
    if (level < 3) continue;
    EXPECT_EQ(distances[12], 17296u);
    std::uint64_t others = 0;
    for (int distance = 0; distance <= 48; ++distance) {
      if (distance % 4 != 0) others += distances[distance];
    }
    EXPECT_EQ(others, 0u);
  }
  EXPECT_EQ(least, (std::vector<int>{24, 20, 16, 12}));
}

}  // namespace
}  // namespace tagmint::codec
