#include "tagmint/codec/rotation_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/fixed_random.h"
#include "support/rotation_codes.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using Address = RotationCode::Address;

/// Small enough to look at each word.
std::vector<RotationCodeParts> small_codes() {
  return {test::chain_of_16_bits(), test::cosets_of_16_bits(), test::chain_of_25_bits(),
          test::coset_of_25_bits(), RotationCodeParts{.bits = 1, .basis = {1}}};
}

/// The message with which the constructor refuses the parts; empty when it takes them.
std::string refusal(const RotationCodeParts& parts) {
  try {
    const RotationCode code(parts);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Tags among the words of a level, counted one by one.
std::size_t counted_tags(const RotationCode& code, std::size_t level) {
  std::size_t words_of_tags = 0;
  const RotationCodeLevel& part = code.levels()[level];
  for (Address coset = 0; coset < part.cosets; ++coset) {
    for (Address message = 0; message < Address{1} << part.dimension; ++message) {
      const Codeword word = code.word(coset << code.dimension() | message);
      words_of_tags += rotate(word, code.bits(), 2) != word;
    }
  }
  return words_of_tags / 4;
}

std::vector<std::size_t> tags_by_level(const RotationCode& code) {
  std::vector<std::size_t> tags;
  for (std::size_t level = 0; level < code.levels().size(); ++level) {
    tags.push_back(code.tags(level));
  }
  return tags;
}

TEST(RotationCode, CountsTheTagsOfEachLevel) {
  using Tags = std::vector<std::size_t>;
  EXPECT_EQ(tags_by_level(RotationCode(test::chain_of_36_bits())), (Tags{60, 2016, 8128, 130816}));
  EXPECT_EQ(tags_by_level(RotationCode(test::chain_of_48_bits())), (Tags{6, 120, 16320, 4193280}));
  EXPECT_EQ(tags_by_level(RotationCode(test::chain_of_25_bits())), (Tags{56, 120, 480}));
  EXPECT_EQ(tags_by_level(RotationCode(test::coset_of_25_bits())), (Tags{64}));
  EXPECT_EQ(tags_by_level(RotationCode(test::chain_of_16_bits())), (Tags{3, 28, 60, 120}));
  EXPECT_EQ(tags_by_level(RotationCode(test::cosets_of_16_bits())), (Tags{4, 16}));
}

TEST(RotationCode, CountsTagsAsLookingAtEachWordDoes) {
  std::vector<RotationCodeParts> codes = small_codes();
  codes.push_back(test::chain_of_36_bits());
  for (const RotationCodeParts& parts : codes) {
    const RotationCode code(parts);
    for (std::size_t level = 0; level < code.levels().size(); ++level) {
      EXPECT_EQ(code.tags(level), counted_tags(code, level)) << code.bits() << ' ' << level;
    }
  }
}

TEST(RotationCode, AWordIsTheTranslationACosetAndWordsOfTheBasis) {
  const RotationCodeParts parts = test::cosets_of_16_bits();
  const RotationCode code(parts);
  EXPECT_EQ(code.words(), 64u);
  EXPECT_EQ(code.words(0), 16u);
  EXPECT_EQ(code.word(5 << 2 | 0), parts.translation ^ parts.cosets[5]);
  EXPECT_EQ(code.word(5 << 2 | 3),
            parts.translation ^ parts.cosets[5] ^ parts.basis[0] ^ parts.basis[1]);
}

TEST(RotationCode, FindsTheAddressOfEachWordAndNoOther) {
  for (const RotationCodeParts& parts : small_codes()) {
    const RotationCode code(parts);
    std::set<Codeword> words;
    for (Address address = 0; address < code.words(); ++address) {
      const Codeword word = code.word(address);
      words.insert(word);
      ASSERT_EQ(code.find(word), address) << code.bits();
    }
    EXPECT_EQ(words.size(), code.words()) << "words must differ";
    for (Codeword word = 0; word <= std::min(low_mask(16), low_mask(code.bits())); ++word) {
      ASSERT_EQ(code.find(word).has_value(), words.contains(word)) << code.bits() << ' ' << word;
    }
    if (code.bits() < kMaxBits) {
      EXPECT_FALSE(code.find(code.word(0) | Codeword{1} << code.bits())) << "a bit too many";
    }
  }
}

TEST(RotationCode, TurnsAddressesAsItTurnsWords) {
  for (const RotationCodeParts& parts : small_codes()) {
    const RotationCode code(parts);
    for (Address address = 0; address < code.words(); ++address) {
      ASSERT_EQ(code.word(code.turned(address)), rotate_quarter(code.word(address), code.bits()));
    }
  }
}

TEST(RotationCode, ServesLargeCodesAlike) {
  const RotationCode code(test::chain_of_48_bits());
  testing::FixedRandom random(48);
  for (int i = 0; i < 10'000; ++i) {
    const Address address = random.bits() % code.words();
    const Codeword word = code.word(address);
    ASSERT_EQ(code.find(word), address);
    ASSERT_EQ(code.word(code.turned(address)), rotate_quarter(word, 48));
    // Nearer than the distance to a word of the code: none itself.
    ASSERT_FALSE(code.find(word ^ (random.bits() & 0x7ff) ^ 0x800));
  }
}

TEST(RotationCode, EachLevelIsClosedUnderTurns) {
  const RotationCode code(test::chain_of_36_bits());
  for (const RotationCodeLevel& level : code.levels()) {
    const Address words = Address{1} << level.dimension;
    for (Address address = 0; address < words; ++address) {
      ASSERT_LT(code.turned(address), words) << level.dimension;
    }
  }
}

TEST(RotationCode, WithoutLevelsIsOneLevel) {
  RotationCodeParts parts = test::cosets_of_16_bits();
  parts.levels = {};
  const RotationCode code(parts);
  ASSERT_EQ(code.levels().size(), 1u);
  EXPECT_EQ(code.levels()[0], (RotationCodeLevel{2, 16}));
}

TEST(RotationCode, RefusesImpossibleBits) {
  RotationCodeParts parts = test::chain_of_16_bits();
  parts.bits = 18;
  EXPECT_EQ(refusal(parts),
            "a rotation code of 18 bits is not possible; 1 to 64 with a remainder of 0 or 1 by 4 "
            "are");
  parts.bits = 0;
  EXPECT_NE(refusal(parts), "");
  parts.bits = 68;
  EXPECT_NE(refusal(parts), "");
}

TEST(RotationCode, RefusesWordsWithTooManyBits) {
  RotationCodeParts parts = test::chain_of_16_bits();
  parts.basis[2] |= 0x10000;
  EXPECT_EQ(refusal(parts), "basis word 2 (0x0000000000015d6e) has more than 16 bits");
  parts = test::chain_of_16_bits();
  parts.translation = 0x10000;
  EXPECT_EQ(refusal(parts), "the translation (0x0000000000010000) has more than 16 bits");
  parts = test::cosets_of_16_bits();
  parts.cosets[1] = 0x20000;
  EXPECT_EQ(refusal(parts), "coset 1 (0x0000000000020000) has more than 16 bits");
}

TEST(RotationCode, RefusesADependentBasis) {
  RotationCodeParts parts = test::chain_of_16_bits();
  parts.basis[5] = parts.basis[0] ^ parts.basis[3];
  EXPECT_EQ(refusal(parts), "basis word 5 (0x00000000000027ac) is a sum of those before it");
  parts.basis[5] = 0;
  EXPECT_EQ(refusal(parts), "basis word 5 (0x0000000000000000) is a sum of those before it");
}

TEST(RotationCode, RefusesACosetTwice) {
  RotationCodeParts parts = test::cosets_of_16_bits();
  parts.cosets[7] = parts.cosets[2] ^ parts.basis[1];
  EXPECT_EQ(refusal(parts), "cosets 2 and 7 are the same: their difference is a sum of the basis");
  parts.cosets = {};
  EXPECT_EQ(refusal(parts), "a rotation code needs at least one coset");
}

TEST(RotationCode, RefusesTooManyWords) {
  RotationCodeParts parts{.bits = 64};
  for (int i = 0; i < 31; ++i) parts.basis.push_back(Codeword{1} << i);
  EXPECT_EQ(refusal(parts), "1 cosets of 31 basis words are more than 2^30 words");
  parts.basis.resize(30);
  parts.cosets = {0, Codeword{1} << 40};
  EXPECT_EQ(refusal(parts), "2 cosets of 30 basis words are more than 2^30 words");
}

TEST(RotationCode, RefusesLevelsThatDoNotGrowToTheWholeCode) {
  RotationCodeParts parts = test::chain_of_16_bits();
  parts.levels = {{7}, {4}, {9}};
  EXPECT_EQ(refusal(parts),
            "level 1 (dimension 4, cosets 1) must be larger than the level before it");
  parts.levels = {{4}, {4}, {9}};
  EXPECT_NE(refusal(parts), "");
  parts.levels = {{4, 0}, {9}};
  EXPECT_EQ(refusal(parts), "level 0 (dimension 4, cosets 0) must be larger than nothing");
  parts.levels = {{4}, {8}};
  EXPECT_EQ(refusal(parts), "the last level must be the whole code: dimension 9, cosets 1");
}

TEST(RotationCode, RefusesALevelThatTurnsLeave) {
  RotationCodeParts parts = test::chain_of_16_bits();
  std::swap(parts.basis[0], parts.basis[1]);
  parts.levels = {{1}, {9}};
  EXPECT_EQ(refusal(parts),
            "level 0 is not closed under turns: the turn of basis word 0 (0x0000000000008b8b) is "
            "no sum of its 1 basis words");
  parts = RotationCodeParts{.bits = 16, .basis = {0x1234}};
  EXPECT_EQ(refusal(parts),
            "level 0 is not closed under turns: the turn of basis word 0 (0x0000000000001234) is "
            "no sum of its 1 basis words");
}

TEST(RotationCode, RefusesCosetsThatTurnsLeave) {
  RotationCodeParts parts = test::cosets_of_16_bits();
  parts.levels = {{2, 3}, {2, 16}};
  EXPECT_EQ(refusal(parts),
            "level 0 is not closed under turns: the turn of coset 2, translated "
            "(0x0000000000000700), is no word of it");
  parts = test::chain_of_16_bits();
  parts.translation = 1;
  EXPECT_EQ(refusal(parts),
            "level 0 is not closed under turns: the turn of coset 0, translated "
            "(0x0000000000000001), is no word of it");
}

}  // namespace
}  // namespace tagmint::codec
