// Families whose codewords are generated: they are the families with the same codewords listed.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/generated_families.h"
#include "support/rotation_codes.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

std::vector<FamilyParts> generated_families() {
  return {test::generated_16(), test::generated_25(), test::generated_36()};
}

/// The message with which the constructor refuses the parts; empty when it takes them.
std::string refusal(const FamilyParts& parts) {
  try {
    const Family family(parts);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(GeneratedFamily, HasTheTagsOfItsIndex) {
  for (const FamilyParts& parts : generated_families()) {
    const Family family(parts);
    EXPECT_FALSE(family.is_listed());
    EXPECT_EQ(family.generator(), parts.generator);
    ASSERT_NE(family.index(), nullptr);
    EXPECT_EQ(family.size(), parts.generator->tags());
    EXPECT_EQ(family.levels().back().codes, family.size());
    for (std::size_t id = 0; id < family.size(); id += 1 + family.size() / 500) {
      const Codeword word = family.codeword(static_cast<TagId>(id));
      ASSERT_EQ(family.index()->find(word), (TagIndex::Place{static_cast<TagId>(id), 0}));
    }
    const Family copy = family;  // NOLINT(performance-unnecessary-copy-initialization)
    EXPECT_EQ(copy.index(), family.index());
  }
}

TEST(GeneratedFamily, GivesAnyStretchOfItsCodewords) {
  for (const FamilyParts& parts : generated_families()) {
    const Family family(parts);
    const std::vector<Codeword> all = first_codewords(family, family.size());
    ASSERT_EQ(all.size(), family.size());
    for (std::size_t id = 0; id < all.size(); ++id) {
      ASSERT_EQ(all[id], family.codeword(static_cast<TagId>(id)));
    }
    // Across the ends of levels and of their accepted tags.
    for (const std::size_t first : {0ul, 3ul, 59ul, 61ul, 1883ul, 2010ul, 8127ul, 130815ul}) {
      for (const std::size_t count : {0ul, 1ul, 7ul, 500ul, 8000ul}) {
        const std::vector<Codeword> some = some_codewords(family, static_cast<TagId>(first), count);
        const std::size_t begin = std::min(first, all.size());
        const std::size_t end = std::min(first + count, all.size());
        ASSERT_TRUE(std::equal(some.begin(), some.end(), all.begin() + begin, all.begin() + end))
            << first << ' ' << count;
      }
    }
    EXPECT_EQ(first_codewords(family, family.size() + 5), all);
  }
}

TEST(GeneratedFamily, ListedFamiliesGiveStretchesToo) {
  const Family family = test::listed(Family(test::generated_25()));
  EXPECT_TRUE(family.is_listed());
  EXPECT_EQ(family.generator(), nullptr);
  EXPECT_EQ(family.index(), nullptr);
  const auto all = family.codewords();
  EXPECT_TRUE(std::ranges::equal(some_codewords(family, 60, 9), all.subspan(60)));
  EXPECT_TRUE(std::ranges::equal(some_codewords(family, 2, 3), all.subspan(2, 3)));
  EXPECT_TRUE(some_codewords(family, 64, 1).empty());
  EXPECT_TRUE(some_codewords(family, 900, 1).empty());
}

TEST(GeneratedFamily, HasTheDigestOfItsCodewords) {
  for (const FamilyParts& parts : generated_families()) {
    const Family family(parts);
    EXPECT_EQ(family_digest(family), family_digest(test::listed(family)));
  }
}

TEST(GeneratedFamily, DecodesAsTheListedOne) {
  const auto family = std::make_shared<const Family>(test::generated_16());
  const auto same = std::make_shared<const Family>(test::listed(*family));
  const Decoder decoder(family);
  const Decoder reference(same, {.max_errors = {},
                                 .allow_unsafe_radius = false,
                                 .engine = DecoderEngine::BruteForce,
                                 .ids = {}});
  for (Codeword word = 0; word < 1 << 16; ++word) {
    ASSERT_EQ(decoder.decode(word), reference.decode(word)) << word;
  }
}

TEST(GeneratedFamily, RefusesWhatDoesNotFitTogether) {
  const auto broken = [](const std::function<void(FamilyParts&)>& change) {
    FamilyParts parts = test::generated_16();
    change(parts);
    return refusal(parts);
  };
  EXPECT_EQ(broken([](FamilyParts&) {}), "");
  EXPECT_EQ(broken([](FamilyParts& parts) { parts.codewords = {1}; }),
            "a family has codewords or a generator, not both");
  EXPECT_EQ(broken([](FamilyParts& parts) { parts.generator = nullptr; }),
            "a family needs at least one codeword");
  EXPECT_EQ(broken([](FamilyParts& parts) { parts.layout = classic_layout(9); }),
            "the generator makes words of 16 bits, the layout has 25 data cells");
  EXPECT_EQ(broken([](FamilyParts& parts) { parts.levels = {}; }),
            "the family has 1 levels, its generator 2");
  EXPECT_EQ(broken([](FamilyParts& parts) { parts.levels[0].codes = 3; }),
            "level 0 has 3 codes, the generator makes 4");
  EXPECT_EQ(broken([](FamilyParts& parts) { parts.levels[1].min_hamming = 6; }),
            "level 1 must have more codes and a smaller distance than level 0");
  EXPECT_EQ(broken([](FamilyParts& parts) { parts.levels[1].plain = 13; }),
            "level 1 has 13 plain tags, but adds only 12 tags");
  EXPECT_EQ(broken([](FamilyParts& parts) {
              parts.generator = std::make_shared<const RotationCode>(
                  RotationCodeParts{.bits = 16, .basis = {0xffff}});
              parts.levels = {};
            }),
            "level 0 of the generator has no tags");
}

TEST(GeneratedFamilyFile, HoldsTheGeneratorInsteadOfCodes) {
  const std::string text = format_family(Family(test::generated_16()));
  const std::size_t from = text.find("  \"levels\"");
  ASSERT_NE(from, std::string::npos);
  EXPECT_EQ(text.substr(from), R"(  "levels":[
    {"codes":4,"min_hamming":6},
    {"codes":16,"min_hamming":5}
  ],
  "sha256":"deee9eb2aa5eace245e9604fd833efa54d40b8b1ae618012e9ff102ad79dc4cf",
  "generator":{
    "basis":[
      "0x0000000000005555",
      "0x0000000000008d8d"
    ],
    "translation":"0x0000000000000007",
    "cosets":[
      "0x0000000000000000",
      "0x0000000000000077",
      "0x0000000000000707",
      "0x0000000000002552",
      "0x00000000000000bc",
      "0x0000000000000bb7",
      "0x000000000000368a",
      "0x0000000000003d81",
      "0x000000000000014d",
      "0x00000000000014a7",
      "0x0000000000001f53",
      "0x0000000000002d9e",
      "0x00000000000002c3",
      "0x0000000000002c47",
      "0x0000000000001cdd",
      "0x000000000000157e"
    ],
    "levels":[
      {"dimension":2,"cosets":4},
      {"dimension":2,"cosets":16}
    ]
  }
}
)");
}

TEST(GeneratedFamilyFile, ComesBackAsItWasWritten) {
  for (FamilyParts parts : generated_families()) {
    parts.origin = {"rotation-code", "", "7", "", "test"};
    const Family family(parts);
    const std::string text = format_family(family);
    EXPECT_LT(text.size(), 4000u);
    EXPECT_EQ(text.find("\"codes\":["), std::string::npos);
    const Family back = parse_family(text, "memory");
    EXPECT_EQ(back.name(), family.name());
    EXPECT_EQ(back.layout(), family.layout());
    EXPECT_EQ(back.min_hamming(), family.min_hamming());
    EXPECT_EQ(back.complexity(), family.complexity());
    EXPECT_EQ(back.origin(), family.origin());
    EXPECT_TRUE(std::ranges::equal(back.levels(), family.levels()));
    EXPECT_TRUE(std::ranges::equal(back.generator()->basis(), family.generator()->basis()));
    EXPECT_EQ(back.generator()->translation(), family.generator()->translation());
    EXPECT_TRUE(std::ranges::equal(back.generator()->cosets(), family.generator()->cosets()));
    EXPECT_TRUE(std::ranges::equal(back.generator()->levels(), family.generator()->levels()));
    EXPECT_EQ(back.declared_digest(), family_digest(family));
    EXPECT_EQ(format_family(back), text);
  }
}

TEST(GeneratedFamilyFile, KeysOfTheGeneratorMayBeMissing) {
  // A translation of 0, the coset of 0, one level.
  FamilyParts parts = test::generated_16();
  parts.generator = std::make_shared<const RotationCode>([] {
    RotationCodeParts chain = test::chain_of_16_bits();
    chain.levels = {};
    return chain;
  }());
  parts.levels = {};
  parts.min_hamming = 4;
  const Family family(parts);
  std::string text = format_family(family);
  const std::size_t from = text.find(",\n    \"translation\"");
  const std::size_t to = text.rfind("\n  }\n}");
  ASSERT_LT(from, to);
  text.erase(from, to - from);
  const Family back = parse_family(text, "memory");
  EXPECT_EQ(back.size(), 120u);
  EXPECT_EQ(first_codewords(back, 120), first_codewords(family, 120));
}

}  // namespace
}  // namespace tagmint::codec
