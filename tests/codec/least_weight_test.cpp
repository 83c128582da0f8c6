#include "search/rotation/least_weight.h"

#include <gtest/gtest.h>

#include <set>

#include "search/rotation/gray_walk.h"
#include "support/fixed_random.h"
#include "support/turn_codes.h"

namespace tagmint::codec {
namespace {

TEST(GrayWalk, MeetsEachWordOnceOneBasisWordAfterTheOther) {
  const std::vector<Codeword> basis = {0x31, 0x7, 0xc0, 0x11, 0xff00};
  for (const std::size_t stretch : {1, 3, 7, 8, 32, 100}) {
    GrayWalk walk(basis);
    std::vector<Codeword> all;
    std::vector<Codeword> words;
    for (walk.next(stretch, words); !words.empty(); walk.next(stretch, words)) {
      EXPECT_LE(words.size(), stretch);
      all.insert(all.end(), words.begin(), words.end());
    }
    EXPECT_EQ(all.front(), 0U);
    for (std::size_t i = 1; i < all.size(); ++i) {
      EXPECT_NE(std::find(basis.begin(), basis.end(), all[i] ^ all[i - 1]), basis.end());
    }
    EXPECT_EQ(all.size(), 32U);
    EXPECT_EQ(std::set<Codeword>(all.begin(), all.end()).size(), 32U);
    walk.next(stretch, words);
    EXPECT_TRUE(words.empty());
  }
}

TEST(GrayWalk, OfNoBasisIsTheWordZero) {
  GrayWalk walk({});
  std::vector<Codeword> words;
  walk.next(10, words);
  EXPECT_EQ(words, std::vector<Codeword>{0});
  walk.next(10, words);
  EXPECT_TRUE(words.empty());
}

TEST(LeastWeight, IsThatOfAllSumsButZero) {
  testing::FixedRandom random(1);
  for (int dimension = 1; dimension <= 15; ++dimension) {
    for (const int bits : {16, 25, 64}) {
      const std::vector<Codeword> words = [&] {
        TurnCode code(bits);
        while (code.dimension() < dimension) {
          code.extend(one_step_extensions(code, nullptr)[random.bits() % 2 == 0 ? 0 : 1]);
        }
        return std::vector<Codeword>(code.basis().begin(), code.basis().end());
      }();
      EXPECT_EQ(least_weight(words), test::plain_least_weight(words)) << bits << " " << dimension;
    }
  }
}

TEST(LeastWeight, SeesTheLightestWordWhereverItIs) {
  // Heavy words of 64 bits and, at each step of the basis, one light one.
  for (std::size_t light = 0; light < 14; ++light) {
    std::vector<Codeword> basis;
    for (std::size_t i = 0; i < 14; ++i) {
      basis.push_back(i == light ? Codeword{1} << 63 : ~Codeword{0} << 15 >> 1 | Codeword{1} << i);
    }
    EXPECT_EQ(least_weight(basis), test::plain_least_weight(basis));
    EXPECT_EQ(least_weight(basis), 1);
  }
}

TEST(LeastWeight, OfNoWordsIsMoreThanAllBits) { EXPECT_EQ(least_weight({}), kMaxBits + 1); }

}  // namespace
}  // namespace tagmint::codec
