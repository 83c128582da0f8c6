#include "search/rotation/known_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

/// Codes of more words are not enumerated here.
constexpr int kMostDimensions = 24;

const std::vector<KnownChain>& chains() {
  static const std::vector<KnownChain> all = known_chains();
  return all;
}

TEST(KnownChains, AreClosedAndNestedWithFallingDistances) {
  for (const KnownChain& chain : chains()) {
    SCOPED_TRACE(chain.name);
    ASSERT_FALSE(chain.codes.empty());
    for (std::size_t i = 0; i < chain.codes.size(); ++i) {
      EXPECT_EQ(chain.codes[i].code.bits(), chain.bits);
      EXPECT_TRUE(test::is_closed(chain.codes[i].code));
      if (i == 0) continue;
      EXPECT_TRUE(test::contains(chain.codes[i].code, chain.codes[i - 1].code));
      EXPECT_GT(chain.codes[i].code.dimension(), chain.codes[i - 1].code.dimension());
      EXPECT_LT(chain.codes[i].distance, chain.codes[i - 1].distance);
    }
  }
}

TEST(KnownChains, HaveTheDimensionsAndDistancesOfTheLiterature) {
  using Figures = std::vector<std::pair<int, int>>;  // dimension, distance
  const std::map<std::string, Figures> expected = {
      {"extended quadratic residue code of 7", {{4, 4}}},
      {"extended quadratic residue code of 23", {{12, 8}}},
      {"extended quadratic residue code of 31", {{16, 8}}},
      {"extended quadratic residue code of 47", {{24, 12}}},
      {"extended BCH code of length 16", {{5, 8}, {7, 6}, {11, 4}}},
      {"extended BCH code of length 64",
       {{7, 32},
        {10, 28},
        {16, 24},
        {18, 22},
        {24, 16},
        {30, 14},
        {36, 12},
        {39, 10},
        {45, 8},
        {51, 6},
        {57, 4}}}};
  ASSERT_EQ(chains().size(), expected.size());
  for (const KnownChain& chain : chains()) {
    Figures figures;
    for (const KnownCode& known : chain.codes) {
      figures.emplace_back(known.code.dimension(), known.distance);
    }
    EXPECT_EQ(figures, expected.at(chain.name)) << chain.name;
  }
}

TEST(KnownChains, HaveTheirDistanceWordByWord) {
  for (const KnownChain& chain : chains()) {
    for (const KnownCode& known : chain.codes) {
      if (known.code.dimension() > kMostDimensions) continue;
      EXPECT_EQ(test::plain_least_weight(known.code.rows()), known.distance)
          << chain.name << ", dimension " << known.code.dimension();
    }
  }
}

/// Bits that are set in no word.
Codeword always_zero(const TurnCode& code) {
  Codeword used = 0;
  for (const Codeword row : code.rows()) used |= row;
  return low_mask(code.bits()) & ~used;
}

TEST(FitChain, IsClosedNestedAndNotLessFarApartInAnyNumberOfBits) {
  RandomChoice random(1);
  for (const KnownChain& chain : chains()) {
    for (const int bits : {1, 4, 5, 9, 16, 21, 25, 36, 41, 48, 49, 52, 64}) {
      SCOPED_TRACE(chain.name + " in " + std::to_string(bits));
      const KnownChain fitted = fit_chain(chain, bits, random);
      EXPECT_EQ(fitted.name, chain.name);
      EXPECT_EQ(fitted.bits, bits);
      const TurnCode* before = nullptr;
      for (const KnownCode& known : fitted.codes) {
        EXPECT_EQ(known.code.bits(), bits);
        EXPECT_GT(known.code.dimension(), 0);
        EXPECT_LE(known.code.dimension(), 30);
        EXPECT_TRUE(test::is_closed(known.code));
        if (bits % 4 == 1) {
          EXPECT_EQ(always_zero(known.code) & 1, 1U) << "the centre bit";
        }
        if (before != nullptr) {
          EXPECT_TRUE(test::contains(known.code, *before));
        }
        before = &known.code;
        if (known.code.dimension() <= 16) {
          EXPECT_GE(test::plain_least_weight(known.code.rows()), known.distance);
        }
      }
    }
  }
}

const KnownChain& chain_named(const std::string& name) {
  const auto found = std::find_if(chains().begin(), chains().end(),
                                  [&](const KnownChain& chain) { return chain.name == name; });
  EXPECT_NE(found, chains().end());
  return *found;
}

TEST(FitChain, ShortensByOneDimensionForEachBitThatGoes) {
  // The dual of the residue code of 47 is the code itself, so that each up to 11 places are
  // independent checks.
  RandomChoice random(2);
  const KnownChain& chain = chain_named("extended quadratic residue code of 47");
  for (const int bits : {44, 45, 40, 41}) {
    const KnownChain fitted = fit_chain(chain, bits, random);
    ASSERT_EQ(fitted.codes.size(), 1U);
    EXPECT_EQ(fitted.codes.front().code.dimension(), 24 - (48 - bits + bits % 4));
  }
}

TEST(FitChain, KeepsTheWholeCodeWhereItIsShorter) {
  RandomChoice random(3);
  const KnownChain& chain = chain_named("extended quadratic residue code of 23");
  for (const int bits : {24, 25, 36, 41}) {
    const KnownChain fitted = fit_chain(chain, bits, random);
    ASSERT_EQ(fitted.codes.size(), 1U);
    const TurnCode& code = fitted.codes.front().code;
    EXPECT_EQ(code.dimension(), 12);
    EXPECT_EQ(test::plain_least_weight(code.rows()), 8);
    EXPECT_EQ(std::popcount(always_zero(code)), bits - 24);
  }
}

TEST(FitChain, ChoosesCyclesAtRandom) {
  const KnownChain& chain = chain_named("extended BCH code of length 64");
  const auto rows = [&](std::uint64_t seed) {
    RandomChoice random(seed);
    const KnownChain fitted = fit_chain(chain, 52, random);
    const auto all = fitted.codes.back().code.rows();
    return std::vector<Codeword>(all.begin(), all.end());
  };
  EXPECT_EQ(rows(4), rows(4));
  EXPECT_NE(rows(4), rows(5));
}

TEST(FitChain, LeavesOutCodesWithoutAWordAndTooLargeOnes) {
  RandomChoice random(6);
  const KnownChain& bch = chain_named("extended BCH code of length 64");
  EXPECT_EQ(fit_chain(bch, 64, random).codes.back().code.dimension(), 30);
  EXPECT_TRUE(fit_chain(bch, 1, random).codes.empty());
}

}  // namespace
}  // namespace tagmint::codec
