#include "search/near_list.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "support/instruction_sets.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::with_every_instruction_set;

NearList random_list(std::size_t count, int most_radius, std::uint32_t seed) {
  std::mt19937 random(seed);
  NearList list;
  for (std::size_t i = 0; i < count; ++i) {
    list.push_back(near_entry(random(), static_cast<int>(random() % (most_radius + 1))));
  }
  return list;
}

std::vector<NearEntry> entries_of(const NearList& list) {
  return {list.data(), list.data() + list.size()};
}

TEST(NearList, EntriesHoldBitsAndASignedRadius) {
  EXPECT_EQ(radius_of(near_entry(0xffffff, 0)), 0);
  EXPECT_EQ(radius_of(near_entry(0, 63)), 63);
  EXPECT_EQ(radius_of(near_entry(0xffffff, -1)), -1);
  EXPECT_EQ(near_entry(0xff123456, 3), 0x03123456u);
}

TEST(NearList, NarrowingTakesTheDifferingBitsOffTheRadius) {
  NearList parent;
  parent.push_back(near_entry(0xa123, 3));  // 1010 against 1010: radius 3
  parent.push_back(near_entry(0xb123, 3));  // 1011: one bit differs
  parent.push_back(near_entry(0x5123, 3));  // 0101: all four differ
  parent.push_back(near_entry(0x2123, 1));  // 0010: one bit differs
  NearList child;
  child.append_narrowed(parent, 0xa, 12, 1, 63);
  EXPECT_EQ(entries_of(child), (std::vector{near_entry(0xa123, 3), near_entry(0xb123, 2)}));
  child.append_narrowed(parent, 0xa, 12, 0, 2);
  EXPECT_EQ(entries_of(child), (std::vector{near_entry(0xa123, 3), near_entry(0xb123, 2),
                                            near_entry(0xb123, 2), near_entry(0x2123, 0)}));
}

TEST(NearList, ExcludesWordsWithinARadius) {
  NearList list;
  const std::vector<std::uint32_t> all = {0x00ff, 0x30ff, 0x70ff, 0x1230ff, 0};
  std::vector<std::uint32_t> words = all;
  list.exclude_from(words, 16);
  EXPECT_EQ(words, all) << "nothing excludes";
  list.push_back(near_entry(0x0f00ff, 2));
  list.exclude_from(words, 16);
  EXPECT_EQ(words, (std::vector<std::uint32_t>{0x70ff, 0})) << "three bits differ, and eight";
}

TEST(NearList, TakesSomeEntriesByTheirRadius) {
  NearList source;
  for (const int radius : {0, 1, 2, 3, 4, 2}) source.push_back(near_entry(0x100 + radius, radius));
  NearList some;
  some.append_some(source, 2, 3);
  EXPECT_EQ(entries_of(some),
            (std::vector{near_entry(0x102, 2), near_entry(0x103, 3), near_entry(0x102, 2)}));
}

TEST(NearList, PartsEntriesByTheirRadius) {
  NearList source;
  for (const int radius : {0, 4, 2, 3, 2, 5}) source.push_back(near_entry(radius, radius));
  NearList equal;
  NearList larger;
  equal.push_back(near_entry(7, 7));
  equal.take_equal(source, 2, larger);
  EXPECT_EQ(entries_of(equal), (std::vector{near_entry(2, 2), near_entry(2, 2)}));
  EXPECT_EQ(entries_of(larger),
            (std::vector{near_entry(4, 4), near_entry(3, 3), near_entry(5, 5)}));
  equal.take_equal(larger, 4, larger);
  EXPECT_EQ(entries_of(equal), std::vector{near_entry(4, 4)});
  EXPECT_EQ(entries_of(larger), std::vector{near_entry(5, 5)});
}

TEST(NearList, TakesTheTurnsThatReachASubtree) {
  const std::vector<Codeword> turns = {0xab0000000123, 0xab0001000123, 0xa90000000123,
                                       0xa80000000123};
  NearList list;
  list.append_reaching(SplitTurns(turns), 0xab0000000000, 24, 1);
  EXPECT_EQ(entries_of(list),
            (std::vector{near_entry(0x123, 1), near_entry(0x123, 0), near_entry(0x123, 0)}));
}

TEST(NearList, NarrowingIsTheSameWithEveryInstructionSet) {
  with_every_instruction_set([] {
    for (const std::size_t count : {0, 1, 15, 16, 17, 400}) {
      const NearList parent = random_list(count, 10, 7);
      for (const int shift : {12, 16, 20}) {
        const near_kernels::Narrowing narrowing{NearEntry{0x9} << shift, NearEntry{0xf} << shift,
                                                near_entry(0, 2), near_entry(0, 8)};
        std::vector<NearEntry> expected(count + NearList::kPadding);
        expected.resize(
            near_kernels::narrow_scalar(parent.data(), count, narrowing, expected.data()));
        NearList child;
        child.append_narrowed(parent, 0x9, shift, 2, 7);
        EXPECT_EQ(entries_of(child), expected) << count << " entries";
      }
    }
  });
}

TEST(NearList, PartsAreTheSameWithEveryInstructionSet) {
  with_every_instruction_set([] {
    for (const std::size_t count : {0, 1, 15, 16, 17, 400}) {
      const NearList source = random_list(count, 10, 7);
      std::vector<NearEntry> expected_equal(count + NearList::kPadding);
      std::vector<NearEntry> expected_larger(count + NearList::kPadding);
      const near_kernels::Parts parts = near_kernels::part_scalar(
          source.data(), count, 4, expected_equal.data(), expected_larger.data());
      expected_equal.resize(parts.equal);
      expected_larger.resize(parts.larger);
      NearList equal;
      NearList larger = source;
      equal.take_equal(larger, 4, larger);
      EXPECT_EQ(entries_of(equal), expected_equal) << count << " entries";
      EXPECT_EQ(entries_of(larger), expected_larger) << count << " entries";
    }
  });
}

TEST(NearList, ExclusionIsTheSameWithEveryInstructionSet) {
  with_every_instruction_set([] {
    for (const std::size_t count : {0, 1, 31, 32, 33, 127, 128, 129, 300}) {
      const NearList list = random_list(count, 4, 8);
      std::mt19937 random(9);
      std::vector<std::uint32_t> words(200);
      for (std::uint32_t& word : words) word = random() & 0xffff;
      std::vector<std::uint32_t> expected = words;
      expected.resize(near_kernels::keep_open_scalar(list.data(), count, expected, 0xffff));
      list.exclude_from(words, 16);
      EXPECT_EQ(words, expected) << count << " entries";
    }
  });
}

TEST(NearList, ReachingTurnsAreTheSameWithEveryInstructionSet) {
  std::mt19937_64 random(10);
  std::vector<Codeword> turns(401);
  for (Codeword& turn : turns) turn = random();
  with_every_instruction_set([&] {
    for (const std::size_t count : {0, 1, 15, 16, 17, 401}) {
      for (const int bits : {16, 24, 36, 48, 61}) {
        for (const int undecided : {16, 20, 24}) {
          if (undecided > bits) continue;
          std::vector<Codeword> words(turns.begin(), turns.begin() + count);
          for (Codeword& word : words) word &= low_mask(bits);
          const SplitTurns split(words);
          const Codeword prefix = 0x123456789abcdef0 & low_mask(bits) & ~low_mask(undecided);
          const near_kernels::Subtree subtree{prefix, static_cast<NearEntry>(low_mask(undecided)),
                                              (bits - undecided) / 2};
          std::vector<NearEntry> expected(count + NearList::kPadding);
          expected.resize(near_kernels::reach_scalar(split, subtree, expected.data()));
          NearList list;
          list.append_reaching(split, prefix, undecided, subtree.radius);
          EXPECT_EQ(entries_of(list), expected) << count << " turns of " << bits << " bits";
        }
      }
    }
  });
}

}  // namespace
}  // namespace tagmint::codec
