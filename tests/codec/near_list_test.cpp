#include "search/near_list.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <random>
#include <vector>

#include "search/leaf_paint.h"

namespace tagmint::codec {
namespace {

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

/// Runs `check` with each instruction set that was compiled and that this machine has.
template <typename Check>
void with_every_instruction_set(const Check& check) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    SCOPED_TRACE(hwy::TargetName(target));
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
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
  EXPECT_FALSE(list.excludes(0, 16));
  list.push_back(near_entry(0x0f00ff, 2));
  EXPECT_TRUE(list.excludes(0x00ff, 16));
  EXPECT_TRUE(list.excludes(0x30ff, 16)) << "two bits differ";
  EXPECT_FALSE(list.excludes(0x70ff, 16)) << "three bits differ";
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

TEST(NearList, ExclusionIsTheSameWithEveryInstructionSet) {
  with_every_instruction_set([] {
    for (const std::size_t count : {0, 1, 15, 16, 17, 100}) {
      const NearList list = random_list(count, 4, 8);
      std::mt19937 random(9);
      for (int i = 0; i < 200; ++i) {
        const std::uint32_t word = random() & 0xffff;
        EXPECT_EQ(list.excludes(word, 16),
                  near_kernels::excludes_scalar(list.data(), count, word, 0xffff));
      }
    }
  });
}

TEST(LeafPainter, PaintsHammingBallsWithEveryInstructionSet) {
  const LeafPainter painter;
  with_every_instruction_set([&] {
    for (const std::size_t count : {0, 1, 2, 9, 60}) {
      for (const int most_radius : {0, 3, 6, 12, 40}) {
        const NearList list = random_list(count, most_radius, 10);
        LeafBits painted;
        LeafBits expected;
        const bool full = painter.paint(list, painted);
        EXPECT_EQ(full, LeafPainter::paint_scalar(list, expected));
        EXPECT_EQ(painted.elements, expected.elements)
            << count << " balls of radius up to " << most_radius;
      }
    }
  });
}

TEST(LeafPainter, TellsWhenNothingIsLeft) {
  const LeafPainter painter;
  NearList list;
  LeafBits leaf;
  list.push_back(near_entry(0x123, 11));
  EXPECT_FALSE(painter.paint(list, leaf)) << "the opposite word is left";
  list.push_back(near_entry(~0x123u, 0));
  EXPECT_TRUE(painter.paint(list, leaf));
}

}  // namespace
}  // namespace tagmint::codec
