#include "search/rotation/placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "support/turn_codes.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

constexpr Complexity kEnergy{ComplexityRule::Energy, 0.3333};

Placement random_placement(int bits, RandomChoice& random) {
  Placement placement{bits, std::vector<int>(static_cast<std::size_t>(bits / 4)), {}};
  std::iota(placement.place.begin(), placement.place.end(), 0);
  random.shuffle(placement.place);
  for (int i = 0; i < bits / 4; ++i) placement.blocks.push_back(static_cast<int>(random.below(4)));
  return placement;
}

/// The 56 tags at distance 9 of 25 bits whose best translation makes 64 of them.
CodeChain chain_of_25_bits() {
  const TurnCode code = test::code_of(
      25, {0x9a69a6, 0x17df7de, 0x764765, 0x22e22f, 0xef731, 0x10f39b, 0x337ec, 0x15b27});
  return {{{code, 9}}, "of a test"};
}

/// Words of a level as place_chain() describes it, and how often each weight of a sum of two words
/// occurs.
std::vector<Codeword> words_of(const RotationCodeParts& parts, int dimension) {
  std::vector<Codeword> words =
      test::sums_of(std::span(parts.basis).first(static_cast<std::size_t>(dimension)));
  for (Codeword& word : words) word ^= parts.translation;
  return words;
}

std::size_t tags_among(const std::vector<Codeword>& words, int bits) {
  std::set<Codeword> tags;
  for (const Codeword word : words) {
    if (rotate(word, bits, 2) != word) tags.insert(test::least_turn(word, bits));
  }
  return tags.size();
}

TEST(Placement, MovesEachCellToOneOfItsOwnAndCommutesWithTheTurn) {
  RandomChoice random(1);
  for (const int bits : {4, 9, 16, 25, 36, 64}) {
    const Placement placement = random_placement(bits, random);
    const LinearMap map = placement.map();
    std::set<Codeword> images;
    for (int bit = 0; bit < bits; ++bit) {
      const Codeword cell = Codeword{1} << bit;
      const Codeword image = map(cell);
      EXPECT_EQ(std::popcount(image), 1);
      images.insert(image);
      EXPECT_EQ(map(rotate_quarter(cell, bits)), rotate_quarter(image, bits));
    }
    EXPECT_EQ(images.size(), static_cast<std::size_t>(bits));
    if (bits % 4 == 1) {
      EXPECT_EQ(map(1), 1u) << "the centre stays";
    }
  }
}

TEST(Placement, TakesTheFirstPlaceOfABlockWhereItSays) {
  // Two places: the first goes to the second place, one block further.
  const Placement placement{8, {1, 0}, {1, 0}};
  EXPECT_EQ(placement.map()(0b10000000), 0b00010000u);
  EXPECT_EQ(placement.map()(0b01000000), 0b10000000u);
  EXPECT_EQ(placement.map()(0b00000010), 0b01000000u);
}

TEST(PlaceChain, KeepsTheCodeClosedAndItsDistances) {
  RandomChoice random(2);
  const Layout layout = classic_layout(9);
  const CodeChain chain = chain_of_25_bits();
  const RotationCodeParts parts = place_chain(chain, layout, kEnergy, 100, random);
  const std::vector<Codeword> words = words_of(parts, 8);
  const std::set<Codeword> set(words.begin(), words.end());
  std::map<int, int> weights;
  std::map<int, int> expected;
  for (const Codeword word : words) {
    EXPECT_TRUE(set.contains(rotate_quarter(word, 25)));
    ++weights[std::popcount(word ^ words.front())];
  }
  for (const Codeword word : test::words_of(chain.levels.front().code)) {
    ++expected[std::popcount(word)];
  }
  EXPECT_EQ(weights, expected);
}

TEST(PlaceChain, TranslatesToTheMostTags) {
  RandomChoice random(3);
  const CodeChain chain = chain_of_25_bits();
  const TurnCode& code = chain.levels.front().code;
  EXPECT_EQ(tags_among(test::words_of(code), 25), 56u);
  const RotationCodeParts parts = place_chain(chain, classic_layout(9), {}, 0, random);
  EXPECT_EQ(tags_among(words_of(parts, 8), 25), 64u) << "the coset trick";
}

TEST(PlaceChain, OfASmallCodeTranslatesToAsManyTagsAsAnyTranslationMakes) {
  RandomChoice random(4);
  for (int i = 0; i < 10; ++i) {
    const TurnCode code = test::random_code(16, 5, random);
    std::size_t most = 0;
    for (Codeword t = 0; t < 0x10000; ++t) {
      if (!code.contains(turn_difference(t, 16)) || code.reduce(t) != t) continue;
      std::vector<Codeword> words = test::words_of(code);
      for (Codeword& word : words) word ^= t;
      most = std::max(most, tags_among(words, 16));
    }
    const CodeChain chain{{{code, 1}}, "of a test"};
    const RotationCodeParts parts = place_chain(chain, classic_layout(8), {}, 0, random);
    EXPECT_EQ(tags_among(words_of(parts, 5), 16), most);
  }
}

TEST(PlaceChain, MakesMoreTagsComplexThanWithoutTries) {
  const Layout layout = classic_layout(9);
  const ComplexityJudge judge(layout, kEnergy);
  const auto complex_after = [&](int tries) {
    RandomChoice random(5);
    const RotationCodeParts parts = place_chain(chain_of_25_bits(), layout, kEnergy, tries, random);
    const std::vector<Codeword> words = words_of(parts, 8);
    return std::count_if(words.begin(), words.end(),
                         [&](Codeword word) { return judge.accepts(word); });
  };
  EXPECT_GT(complex_after(300), complex_after(0));
}

TEST(PlaceTags, KeepsAllDistances) {
  RandomChoice random(6);
  std::vector<Codeword> tags;
  for (int i = 0; i < 40; ++i) tags.push_back(random.below(1 << 21));
  const std::vector<Codeword> placed =
      place_tags(tags, parse_layout("circle:9"), kEnergy, 50, random);
  ASSERT_EQ(placed.size(), tags.size());
  EXPECT_NE(placed, tags);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    EXPECT_EQ(self_distance(placed[i], 21), self_distance(tags[i], 21));
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_EQ(rotation_distance(placed[i], placed[j], 21),
                rotation_distance(tags[i], tags[j], 21));
    }
  }
}

}  // namespace
}  // namespace tagmint::codec
