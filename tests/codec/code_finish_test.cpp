#include "search/rotation/code_finish.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>

#include "support/turn_codes.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

RotationCodeOptions options_for(const std::string& layout, int min_hamming) {
  return {.layout = parse_layout(layout),
          .min_hamming = min_hamming,
          .complexity = {ComplexityRule::Energy, 0.3333}};
}

/// 3 tags at distance 8 inside 28 at 6 inside 60 at 5, of 16 bits.
CodeChain chain_of_16_bits() {
  const TurnCode code =
      test::code_of(16, {0x3333, 0x8b8b, 0x5d6e, 0x149f, 0x0b38, 0x0536, 0x0355, 0x01d2});
  return {{{code.prefix(4), 7}, {code.prefix(7), 6}, {code, 5}}, "of a test"};
}

/// Levels that are as far apart as they say and end with as many plain tags.
void expect_levels_hold(const FamilyParts& family) {
  const ComplexityJudge judge(family.layout, family.complexity);
  std::size_t begin = 0;
  for (const Level& level : family.levels) {
    const auto all = std::span(family.codewords).first(level.codes);
    EXPECT_TRUE(test::are_apart(all, family.layout.bits(), level.min_hamming));
    EXPECT_FALSE(test::are_apart(all, family.layout.bits(), level.min_hamming + 1));
    for (std::size_t id = begin; id < level.codes; ++id) {
      EXPECT_EQ(judge.accepts(family.codewords[id]), id < level.codes - level.plain);
    }
    begin = level.codes;
  }
}

TEST(FinishChain, TellsTrueDistancesAndPutsPlainTagsLast) {
  RandomChoice random(1);
  const FamilyParts family = finish_chain(chain_of_16_bits(), options_for("classic:8", 5), random);
  EXPECT_EQ(family.generator, nullptr) << "few tags are listed";
  ASSERT_EQ(family.levels.size(), 3u);
  EXPECT_EQ(family.levels[0].min_hamming, 8) << "asked for 7";
  EXPECT_EQ(family.min_hamming, 5);
  EXPECT_EQ(family.codewords.size(), family.levels.back().codes);
  expect_levels_hold(family);
}

TEST(FinishChain, LeavesOutLevelsAsFarApartAsTheNextOrWithoutATag) {
  RandomChoice random(2);
  CodeChain chain = chain_of_16_bits();
  chain.levels.insert(chain.levels.begin(), {TurnCode(16), 16});
  // Two levels of the same code, whatever was asked for.
  chain.levels.insert(chain.levels.end() - 1, {chain.levels.back().code, 6});
  const FamilyParts family = finish_chain(chain, options_for("classic:8", 5), random);
  EXPECT_EQ(family.levels.size(), 3u);
  expect_levels_hold(family);
}

TEST(FinishChain, GivesAGeneratorForMoreTagsThanAreListed) {
  RandomChoice random(3);
  // All words of even weight but of 16 bits: (2^15 - 2^8) / 4 tags at least.
  TurnCode even(16);
  std::vector<Codeword> pairs;
  for (int bit = 1; bit < 16; ++bit) pairs.push_back(Codeword{1} << bit | 1);
  even.adjoin(pairs);
  const FamilyParts family =
      finish_chain({{{even, 2}}, "of a test"}, options_for("classic:8", 2), random);
  ASSERT_NE(family.generator, nullptr);
  EXPECT_TRUE(family.codewords.empty());
  EXPECT_GT(family.levels.back().codes, kMostListedTags);
  EXPECT_EQ(family.levels.back().codes, family.generator->tags());
  EXPECT_EQ(family.min_hamming, 2);
}

TEST(FinishUnion, IsOneLevelWithItsTrueDistanceAndPlainTagsLast) {
  RandomChoice random(4);
  std::vector<Codeword> tags;
  for (Codeword word = 1; tags.size() < 60; word += 0x1f) {
    std::vector<Codeword> more = tags;
    more.push_back(word);
    if (test::are_apart(more, 16, 3)) tags = more;
  }
  const FamilyParts family = finish_union(tags, options_for("classic:8", 3), random);
  ASSERT_EQ(family.levels.size(), 1u);
  EXPECT_EQ(family.codewords.size(), tags.size());
  EXPECT_GT(family.levels.front().plain, 0u);
  expect_levels_hold(family);
}

class FillUp : public testing::Test {
 protected:
  FamilyParts family() {
    RandomChoice random(5);
    CodeChain chain = chain_of_16_bits();
    chain.levels.pop_back();
    return finish_chain(chain, options_for("classic:8", 6), random);
  }
};

TEST_F(FillUp, AddsUntilNoComplexWordIsFarEnough) {
  FamilyParts filled = family();
  const std::vector<Codeword> before = filled.codewords;
  const RotationCodeOptions options = options_for("classic:8", 5);
  const std::size_t added = fill_up(filled, options);
  ASSERT_GT(added, 0u);
  EXPECT_EQ(filled.codewords.size(), before.size() + added);
  ASSERT_EQ(filled.levels.size(), 3u) << "a level of their own, at a smaller distance";
  EXPECT_EQ(filled.levels.back().min_hamming, 5);
  EXPECT_EQ(filled.min_hamming, 5);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), filled.codewords.begin()));
  EXPECT_TRUE(test::are_apart(filled.codewords, 16, 5));
  const ComplexityJudge judge(options.layout, options.complexity);
  for (Codeword word = 0; word < 0x10000; ++word) {
    if (!judge.accepts(word)) continue;
    std::vector<Codeword> more = filled.codewords;
    more.push_back(word);
    EXPECT_FALSE(test::are_apart(more, 16, 5)) << "one more would fit";
  }
}

TEST_F(FillUp, KeepsThePlainTagsLastInALevelThatGrows) {
  FamilyParts filled = family();
  ASSERT_GT(filled.levels.back().plain, 0u);
  // Half of the last level's tags, and room for others.
  filled.codewords.erase(filled.codewords.begin() + 8, filled.codewords.end() - 3);
  filled.levels = {{filled.codewords.size(), 6, 3}};
  const std::vector<Codeword> plain(filled.codewords.end() - 3, filled.codewords.end());
  const std::size_t added = fill_up(filled, options_for("classic:8", 6));
  ASSERT_GT(added, 0u);
  ASSERT_EQ(filled.levels.size(), 1u);
  EXPECT_EQ(filled.levels.back().codes, filled.codewords.size());
  EXPECT_EQ(filled.levels.back().plain, 3u);
  EXPECT_TRUE(std::equal(plain.begin(), plain.end(), filled.codewords.end() - 3));
  EXPECT_TRUE(test::are_apart(filled.codewords, 16, 6));
}

TEST_F(FillUp, AddsNothingWhenItIsStopped) {
  FamilyParts filled = family();
  const std::vector<Codeword> before = filled.codewords;
  std::stop_source stop;
  stop.request_stop();
  RotationCodeOptions options = options_for("classic:8", 5);
  options.stop = stop.get_token();
  EXPECT_EQ(fill_up(filled, options), 0u);
  EXPECT_EQ(filled.codewords, before);
  EXPECT_EQ(filled.levels.size(), 2u);
}

}  // namespace
}  // namespace tagmint::codec
