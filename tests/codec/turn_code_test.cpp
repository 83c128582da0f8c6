#include "search/rotation/turn_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/fixed_random.h"
#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

/// Few enough bits to look at all words; with and without a centre bit.
constexpr int kFewBits[] = {1, 4, 5, 8, 9, 12, 13};

TEST(TurnDifference, FourTimesIsNothingAndThreeTimesIsNot) {
  testing::FixedRandom random(1);
  for (const int bits : {1, 4, 5, 16, 21, 25, 36, 41, 48, 49, 52, 64}) {
    for (int i = 0; i < 100; ++i) {
      const Codeword a = random.bits() & low_mask(bits);
      const Codeword b = random.bits() & low_mask(bits);
      EXPECT_EQ(turn_difference(a ^ b, bits), turn_difference(a, bits) ^ turn_difference(b, bits));
      Codeword word = a;
      for (int step = 0; step < 4; ++step) word = turn_difference(word, bits);
      EXPECT_EQ(word, 0U);
    }
  }
  // One cell gives all four of its cycle after three steps.
  Codeword word = 0b1000;
  for (int step = 0; step < 3; ++step) word = turn_difference(word, 4);
  EXPECT_EQ(word, 0b1111U);
}

TEST(TurnCode, BeginsWithTheWordZero) {
  const TurnCode code(9);
  EXPECT_EQ(code.dimension(), 0);
  EXPECT_TRUE(code.contains(0));
  EXPECT_FALSE(code.contains(1));
  EXPECT_TRUE(code.basis().empty());
}

TEST(TurnCode, ReducesToTheLeastWordOfAClass) {
  RandomChoice random(2);
  for (const int bits : kFewBits) {
    for (int dimension = 0; dimension <= bits; ++dimension) {
      const TurnCode code = test::random_code(bits, dimension, random);
      const std::vector<Codeword> words = test::words_of(code);
      for (int i = 0; i < 10; ++i) {
        const Codeword word = random.below(std::size_t{1} << bits);
        Codeword least = word;
        for (const Codeword other : words) least = std::min(least, word ^ other);
        EXPECT_EQ(code.reduce(word), least);
        EXPECT_EQ(code.contains(word), std::find(words.begin(), words.end(), word) != words.end());
      }
    }
  }
}

TEST(TurnCode, RowsAreAReducedEchelonFormOfTheBasis) {
  RandomChoice random(3);
  for (const int bits : {13, 36, 49, 64}) {
    const TurnCode code = test::random_code(bits, bits / 2, random);
    ASSERT_EQ(static_cast<int>(code.basis().size()), code.dimension());
    ASSERT_EQ(static_cast<int>(code.rows().size()), code.dimension());
    for (const Codeword word : code.basis()) EXPECT_TRUE(code.contains(word));
    for (std::size_t i = 0; i < code.rows().size(); ++i) {
      if (i > 0) {
        EXPECT_LT(code.rows()[i], code.rows()[i - 1]);
      }
      const Codeword pivot = std::bit_floor(code.rows()[i]);
      for (std::size_t j = 0; j < code.rows().size(); ++j) {
        EXPECT_EQ((code.rows()[j] & pivot) != 0, i == j);
      }
    }
  }
}

TEST(TurnCode, ExtendKeepsEachPrefixClosedAndTheBasisAsItWasAdded) {
  RandomChoice random(4);
  for (const int bits : {1, 4, 5, 13, 25, 36, 64}) {
    TurnCode code(bits);
    std::vector<Codeword> added;
    while (code.dimension() < bits) {
      added.push_back(random.of(one_step_extensions(code, nullptr)));
      code.extend(added.back());
      ASSERT_TRUE(std::equal(added.begin(), added.end(), code.basis().begin(), code.basis().end()));
    }
    EXPECT_TRUE(test::prefixes_are_closed(code));
  }
}

TEST(TurnCode, AdjoinAddsWhatTheTurnsSpan) {
  testing::FixedRandom random(5);
  for (const int bits : kFewBits) {
    for (int i = 0; i < 20; ++i) {
      const std::vector<Codeword> first = {random.bits() & low_mask(bits)};
      const std::vector<Codeword> more = {random.bits() & low_mask(bits), 0, first.front()};
      TurnCode code = test::code_of(bits, first);
      const TurnCode before = code;
      code.adjoin(more);
      std::vector<Codeword> turns;
      for (const Codeword word : {first[0], more[0]}) {
        for (int turn = 0; turn < 4; ++turn) turns.push_back(rotate(word, bits, turn));
      }
      const std::vector<Codeword> sums = test::sums_of(turns);
      const std::set<Codeword> span(sums.begin(), sums.end());
      const std::vector<Codeword> words = test::words_of(code);
      EXPECT_EQ(std::set<Codeword>(words.begin(), words.end()), span);
      EXPECT_EQ(words.size(), span.size());
      EXPECT_TRUE(test::prefixes_are_closed(code));
      EXPECT_TRUE(test::begins_with(code, before));
    }
  }
}

/// The classes modulo `code`, by their least words, of all words whose turn difference is in it.
std::set<Codeword> plain_extensions(const TurnCode& code, const TurnCode* inside) {
  std::set<Codeword> classes;
  for (Codeword word = 0; word < Codeword{1} << code.bits(); ++word) {
    if (inside != nullptr && !inside->contains(word)) continue;
    if (code.contains(turn_difference(word, code.bits()))) classes.insert(code.reduce(word));
  }
  return classes;
}

void expect_extensions(const TurnCode& code, const TurnCode* inside) {
  const std::vector<Codeword> ways = one_step_extensions(code, inside);
  EXPECT_LE(static_cast<int>(ways.size()), code.bits() / 4 + 1);
  for (const Codeword way : ways) EXPECT_EQ(code.reduce(way), way);
  const std::vector<Codeword> sums = test::sums_of(ways);
  std::set<Codeword> classes;
  for (const Codeword sum : sums) classes.insert(code.reduce(sum));
  EXPECT_EQ(classes.size(), sums.size()) << "each is in another class";
  EXPECT_EQ(classes, plain_extensions(code, inside));
}

TEST(OneStepExtensions, SpanExactlyWhatKeepsTheCodeClosed) {
  RandomChoice random(6);
  for (const int bits : kFewBits) {
    for (int dimension = 0; dimension <= bits; ++dimension) {
      expect_extensions(test::random_code(bits, dimension, random), nullptr);
    }
  }
}

TEST(OneStepExtensions, StayInsideTheCodeThatIsGiven) {
  RandomChoice random(7);
  for (const int bits : {5, 9, 12, 13}) {
    for (int outer = 0; outer <= bits; ++outer) {
      const TurnCode inside = test::random_code(bits, outer, random);
      // The prefixes of a chain, and codes that are no prefix.
      expect_extensions(inside.prefix(outer / 2), &inside);
      expect_extensions(random_subcode(inside, TurnCode(bits), outer / 3, random), &inside);
      EXPECT_TRUE(one_step_extensions(inside, &inside).empty());
    }
  }
}

TEST(RandomSubcode, IsClosedBetweenTheTwoCodesAndOfThatDimension) {
  RandomChoice random(8);
  for (const int bits : {4, 9, 13, 25, 36, 64}) {
    for (int i = 0; i < 10; ++i) {
      const int outer = 1 + static_cast<int>(random.below(static_cast<std::size_t>(bits)));
      const TurnCode code = test::random_code(bits, outer, random);
      const TurnCode keep =
          code.prefix(static_cast<int>(random.below(static_cast<std::size_t>(outer) + 1)));
      for (int dimension = keep.dimension(); dimension <= outer; ++dimension) {
        const TurnCode subcode = random_subcode(code, keep, dimension, random);
        EXPECT_EQ(subcode.dimension(), dimension);
        EXPECT_TRUE(test::is_closed(subcode));
        EXPECT_TRUE(test::contains(code, subcode));
        EXPECT_TRUE(test::contains(subcode, keep));
        EXPECT_TRUE(test::prefixes_are_closed(subcode));
        EXPECT_TRUE(test::begins_with(subcode, keep));
      }
    }
  }
}

TEST(RandomSubcode, ReachesEachSubcodeOfOneDimensionLess) {
  // Of all words of 8 bits: closed hyperplanes hold all turn differences, which leave two
  // dimensions, one a place, and these have 2^2 - 1 hyperplanes.
  TurnCode all(8);
  all.adjoin(std::vector<Codeword>{1, 2, 4, 8, 16, 32, 64, 128});
  RandomChoice random(9);
  std::set<std::vector<Codeword>> found;
  for (int i = 0; i < 100; ++i) {
    const TurnCode subcode = random_subcode(all, TurnCode(8), 7, random);
    found.insert({subcode.rows().begin(), subcode.rows().end()});
  }
  EXPECT_EQ(found.size(), 3U);
}

}  // namespace
}  // namespace tagmint::codec
