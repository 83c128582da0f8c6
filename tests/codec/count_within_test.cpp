#include "kernels/count_within.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/fixed_random.h"
#include "support/instruction_sets.h"

namespace tagmint::codec {
namespace {

TEST(CountWithin, CountsWordsUpToTheRadius) {
  const std::vector<Codeword> words = {0b0000, 0b0001, 0b0011, 0b0111, 0b1111};
  testing::with_every_instruction_set([&] {
    for (int radius = 0; radius <= 4; ++radius) {
      EXPECT_EQ(count_within(words, 0, radius), static_cast<std::size_t>(radius) + 1);
      EXPECT_EQ(count_within(words, 0b1111, radius), static_cast<std::size_t>(radius) + 1);
    }
    EXPECT_EQ(count_within(words, 0, -1), 0U);
    EXPECT_EQ(count_within(words, ~Codeword{0}, kMaxBits), 5U);
    EXPECT_EQ(count_within({}, 0, kMaxBits), 0U);
  });
}

TEST(CountWithin, EqualsTheScalarReference) {
  testing::with_every_instruction_set([] {
    testing::FixedRandom random(7);
    // Around the widths of vectors, at any place in memory.
    for (std::size_t count = 0; count <= 70; ++count) {
      std::vector<Codeword> words(count + 3);
      for (Codeword& word : words) word = random.bits();
      for (std::size_t begin = 0; begin < 3; ++begin) {
        const auto part = std::span(words).subspan(begin, count);
        const Codeword probe = random.bits();
        for (const int radius : {-1, 0, 26, 30, 32, 34, 40, 63, 64}) {
          ASSERT_EQ(count_within(part, probe, radius), scalar::count_within(part, probe, radius))
              << count << " words, radius " << radius;
        }
      }
    }
  });
}

TEST(CountWithin, CountsManyWords) {
  testing::with_every_instruction_set([] {
    const std::vector<Codeword> words((std::size_t{1} << 17) + 5, 0xff);
    EXPECT_EQ(count_within(words, 0, 8), words.size());
    EXPECT_EQ(count_within(words, 0, 7), 0U);
  });
}

}  // namespace
}  // namespace tagmint::codec
