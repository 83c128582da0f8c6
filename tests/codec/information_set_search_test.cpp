#include "information_set_search.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "support/fixed_random.h"

namespace tagmint::codec {
namespace {

/// Code words by their distance to one word.
using Near = std::map<Codeword, int>;

Near found_by(const InformationSetSearch& search, Codeword word, int radius) {
  Near near;
  search.visit_near(word, [&](Codeword code_word, int distance) {
    near[code_word] = distance;
    return radius;
  });
  return near;
}

/// The same from a list of all words of the code.
Near found_in_list(const std::vector<Codeword>& code, Codeword word, int radius) {
  Near near;
  for (const Codeword code_word : code) {
    const int distance = hamming_distance(code_word, word);
    if (distance <= radius) near[code_word] = distance;
  }
  return near;
}

std::vector<Codeword> all_words(const std::vector<Codeword>& basis,
                                const std::vector<Codeword>& shifts) {
  std::vector<Codeword> words = shifts;
  for (const Codeword word : basis) {
    const std::size_t half = words.size();
    for (std::size_t i = 0; i < half; ++i) words.push_back(words[i] ^ word);
  }
  return words;
}

/// `count` words with a bit of their own each, so that they are independent; the other bits are
/// zero outside of `mask`.
std::vector<Codeword> independent_words(int bits, int count, Codeword mask,
                                        testing::FixedRandom& random) {
  std::vector<Codeword> words;
  for (int i = 0; i < count; ++i) {
    words.push_back((random.bits() & low_mask(bits) & mask & ~low_mask(count)) | Codeword{1} << i);
  }
  return words;
}

/// Compares with the list for random words and words near the code, at every radius up to `most`.
void expect_all_found(const std::vector<Codeword>& basis, const std::vector<Codeword>& shifts,
                      int bits, int most) {
  const std::vector<Codeword> code = all_words(basis, shifts);
  testing::FixedRandom random(5);
  for (int radius = 0; radius <= most; ++radius) {
    const InformationSetSearch search(basis, shifts, bits, radius);
    for (int probe = 0; probe < 16; ++probe) {
      Codeword word = random.bits() & low_mask(bits);
      if (probe % 2 == 0) {
        word = code[random.bits() % code.size()];
        for (int flips = 0; flips < probe / 2; ++flips) {
          word ^= Codeword{1} << random.bits() % static_cast<unsigned>(bits);
        }
      }
      ASSERT_EQ(found_by(search, word, radius), found_in_list(code, word, radius))
          << bits << " bits, dimension " << basis.size() << ", " << shifts.size()
          << " shifts, radius " << radius << ", " << to_hex(word);
    }
  }
}

TEST(InformationSetSearch, FindsAllWordsOfRandomCodesAtAnyRadius) {
  testing::FixedRandom random(1);
  for (const int bits : {1, 4, 5, 9, 16, 21, 25}) {
    for (const int dimension : {0, 1, 2, 5, 8, 11}) {
      if (dimension > bits) continue;
      expect_all_found(independent_words(bits, dimension, ~Codeword{0}, random),
                       {random.bits() & low_mask(bits)}, bits, bits);
    }
  }
}

TEST(InformationSetSearch, FindsAllWordsOfLongCodesAtSmallRadii) {
  testing::FixedRandom random(2);
  for (const int bits : {36, 49, 64}) {
    for (const int dimension : {3, 8, 13}) {
      expect_all_found(independent_words(bits, dimension, ~Codeword{0}, random), {0}, bits, 9);
    }
  }
}

TEST(InformationSetSearch, FindsAllWordsWhereBlocksHaveFewerPositionsThanTheBasisWords) {
  testing::FixedRandom random(3);
  // 16 basis words and 21 bits: a block of 16 positions, one of 5.
  expect_all_found(independent_words(21, 16, ~Codeword{0}, random), {0x5a5}, 21, 5);
  // Bits 15 to 24 are constant zero, and bit 14 repeats bit 0.
  std::vector<Codeword> basis = independent_words(25, 9, low_mask(14), random);
  for (Codeword& word : basis) word ^= (word & 1) << 14;
  expect_all_found(basis, {0, 0x1ff0000}, 25, 6);
}

TEST(InformationSetSearch, SearchesEveryCoset) {
  testing::FixedRandom random(4);
  for (const int dimension : {0, 2, 6}) {
    const std::vector<Codeword> basis = independent_words(25, dimension, ~Codeword{0}, random);
    std::vector<Codeword> shifts;  // differ in bits above those that the basis words own
    for (Codeword i = 0; i < 21; ++i) shifts.push_back(0x1200000 ^ i << 8 ^ i * i << 13);
    expect_all_found(basis, shifts, 25, 8);
  }
}

TEST(InformationSetSearch, TheRadiusCanShrinkOnTheWay) {
  testing::FixedRandom random(6);
  const std::vector<Codeword> basis = independent_words(25, 10, ~Codeword{0}, random);
  const std::vector<Codeword> code = all_words(basis, {0});
  const InformationSetSearch search(basis, std::vector<Codeword>{0}, 25, 25);
  for (int probe = 0; probe < 50; ++probe) {
    const Codeword word = random.bits() & low_mask(25);
    int least = 25;
    search.visit_near(word, [&](Codeword, int distance) {
      EXPECT_LE(distance, least) << "no word beyond the radius that was asked for last";
      least = distance;
      return distance - 1;
    });
    int expected = 25;
    for (const Codeword code_word : code)
      expected = std::min(expected, hamming_distance(word, code_word));
    EXPECT_EQ(least, expected);
  }
}

TEST(InformationSetSearch, NothingMoreIsFoundBelowRadiusZero) {
  const InformationSetSearch search(std::vector<Codeword>{1, 2, 4}, std::vector<Codeword>{0}, 3, 3);
  int found = 0;
  search.visit_near(0, [&](Codeword, int) {
    ++found;
    return -1;
  });
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace tagmint::codec
