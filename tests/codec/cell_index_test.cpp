#include "cell_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

std::vector<Codeword> random_words(int bits, std::size_t count) {
  std::mt19937_64 random(1);
  std::vector<Codeword> words;
  for (std::size_t i = 0; i < count; ++i) words.push_back(random() & low_mask(bits));
  return words;
}

struct Case {
  int bits;
  std::size_t words;
  int turns;
  CellMask cells;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {36, 500, 4, {18, low_mask(18)}},                       // hashed
      {36, 500, 4, {9, low_mask(9) << 18 | low_mask(9)}},     // hashed, two runs
      {36, 500, 1, {6, low_mask(6)}},                         // by value
      {64, 300, 4, {0, ~Codeword{0}}},                        // whole words
      {64, 300, 4, {16, low_mask(16) << 32 | low_mask(16)}},  // two runs of the widest word
      {16, 50, 1, {3, 0}},                                    // no cells: all in one bucket
      {5, 3, 4, {3, low_mask(2)}},
  };
  return all;
}

TEST(CellIndex, HasEveryTurnOfEveryWordAtItsPlace) {
  for (const Case& one : cases()) {
    const std::vector<Codeword> words = random_words(one.bits, one.words);
    const CellIndex index(words, one.bits, one.turns, one.cells);
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (int turn = 0; turn < one.turns; ++turn) {
        const CellIndex::Place place = index.place(rotate(words[i], one.bits, turn));
        EXPECT_EQ(index.may_hold(place), 1u);
        const auto entries = index.entries(place);
        const auto entry = static_cast<CellIndex::Entry>(4 * i) + static_cast<unsigned>(turn);
        EXPECT_EQ(std::count(entries.begin(), entries.end(), entry), 1);
      }
    }
  }
}

TEST(CellIndex, HasThemNowhereElse) {
  // Every entry of a place that is looked at by value has these cells.
  const std::vector<Codeword> words = random_words(36, 500);
  const CellMask cells{6, low_mask(6)};
  const CellIndex index(words, 36, 1, cells);
  std::size_t seen = 0;
  for (Codeword value = 0; value < 64; ++value) {
    for (const CellIndex::Entry entry : index.entries(index.place(value << 6))) {
      EXPECT_EQ(cells.of(words[entry / 4]), value);
      ++seen;
    }
  }
  EXPECT_EQ(seen, words.size());
}

TEST(CellIndex, RefusesNearlyAllOtherWordsWhereTheCellsAreMany) {
  for (const std::size_t count : {100u, 2000u, 30000u}) {
    const CellIndex index(random_words(52, count), 52, 4, {26, low_mask(26)});
    std::mt19937_64 random(2);
    std::size_t passed = 0;
    for (int i = 0; i < 10000; ++i) passed += index.may_hold(index.place(random() & low_mask(52)));
    EXPECT_LT(passed, 300u) << count << " words";
  }
}

TEST(CellIndex, TakesSomeTenBytesAnEntry) {
  const CellIndex index(random_words(52, 30000), 52, 4, {26, low_mask(26)});
  EXPECT_LT(index.bytes(), 120000u * 13);
  EXPECT_GT(index.bytes(), 120000u * 4);
}

}  // namespace
}  // namespace tagmint::codec
