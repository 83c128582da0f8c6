#include "tagmint/codec/search/order.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::codec {
namespace {

constexpr Order kAprilTag2{Order::Kind::AprilTag2};
constexpr Order kAprilTag3{Order::Kind::AprilTag3};

std::string message_of(const std::string& text) {
  try {
    parse_order(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Order, TextComesBack) {
  for (const char* text : {"apriltag2", "apriltag3", "seed:0", "seed:-5",
                           "seed:9223372036854775807", "seed:-9223372036854775808"}) {
    EXPECT_EQ(to_string(parse_order(text)), text);
  }
}

TEST(Order, FaultsAreNamed) {
  EXPECT_EQ(message_of("apriltag"),
            "unknown order 'apriltag'; did you mean 'apriltag2'? orders are apriltag2, apriltag3, "
            "seed:N");
  EXPECT_NE(message_of("sed:4").find("did you mean 'seed'?"), std::string::npos);
  EXPECT_NE(message_of("").find("orders are"), std::string::npos);
  for (const char* seed : {"seed:", "seed:x", "seed:4x", "seed: 4", "seed:9223372036854775808"}) {
    EXPECT_NE(message_of(seed).find("whole number"), std::string::npos) << seed;
  }
}

TEST(Order, SeedsAreThoseOfThePublishedFamilies) {
  const auto seed = [](Order order, const char* layout, int h, const Complexity& complexity) {
    return walk_seed(order, parse_layout(layout), h, complexity);
  };
  const Complexity energy{ComplexityRule::Energy, 0.3333};
  EXPECT_EQ(seed(kAprilTag2, "classic:10", 11, {ComplexityRule::Rectangles, 10}), 361110);
  EXPECT_EQ(seed(kAprilTag2, "classic:8", 5, {ComplexityRule::Rectangles, 5}), 160505);
  EXPECT_EQ(seed(kAprilTag2, "classic:8", 5, {}), 160500);
  EXPECT_EQ(seed(kAprilTag3, "circle:9", 7, energy), 210710);
  EXPECT_EQ(seed(kAprilTag3, "standard:9", 12, energy), 411210);
  EXPECT_EQ(seed(kAprilTag3, "circle:11", 12, energy), 491215);
  EXPECT_EQ(seed(kAprilTag3, "standard:10", 13, energy), 521312);
  EXPECT_EQ(seed({Order::Kind::Seed, -7}, "standard:10", 13, energy), -7);
}

TEST(Walk, VisitsEachWordOnceAndItsFirstOneLast) {
  for (const Order& order : {kAprilTag2, kAprilTag3, Order{Order::Kind::Seed, 3}}) {
    const Walk walk(classic_layout(8), order, 160505);
    std::set<Codeword> seen;
    for (std::uint64_t i = 1; i <= 1u << 16; ++i) {
      const Codeword word = walk.at(i);
      EXPECT_LT(word, 1u << 16);
      seen.insert(word);
      ASSERT_EQ(walk.position_of(word), i);
    }
    EXPECT_EQ(seen.size(), 1u << 16);
    EXPECT_EQ(walk.at(1u << 16), walk.at(0));
  }
}

TEST(Walk, StepsByThePublishedPrimeFromJavasFirstLong) {
  const Walk walk(standard_layout(9), kAprilTag3, 411210);
  const Codeword start = 6969087040467347275u & low_mask(41);
  EXPECT_EQ(walk.at(1), (start + 982451653u) & low_mask(41));
  EXPECT_EQ(walk.at(1000), (start + 982451653000u) & low_mask(41));
}

TEST(Walk, PositionsOf64BitsWrap) {
  const Walk walk(classic_layout(12), kAprilTag2, 1);
  EXPECT_EQ(walk.position_of(walk.at(0)), 0u);
  EXPECT_EQ(walk.position_of(walk.at(~std::uint64_t{0})), ~std::uint64_t{0});
}

TEST(Walk, AprilTag2CountsInTheBottomRightCorner) {
  // The published generator's grid is the printed tag turned by 180 degrees, lowest bit first.
  const Layout layout = classic_layout(8);
  const Walk walk(layout, kAprilTag2, 0);
  for (int bit = 0; bit < 16; ++bit) {
    const TagCells cells = tag_cells(layout, walk.to_codeword(Codeword{1} << bit));
    EXPECT_EQ(cells.at(5 - bit % 4, 5 - bit / 4), Cell::White) << bit;
  }
}

TEST(BitPermutation, ReadingOrderGoesRowByRowWhateverTheLayout) {
  for (const char* name : {"classic:9", "standard:9", "circle:11"}) {
    const Layout layout = parse_layout(name);
    const BitPermutation permutation = reading_order(layout);
    Codeword word = 0x123456789abcdefu & low_mask(layout.bits());
    const Codeword read = permutation(word);
    const TagCells cells = tag_cells(layout, word);
    int bit = layout.bits();
    for (int y = 0; y < layout.width(); ++y) {
      for (int x = 0; x < layout.width(); ++x) {
        if (layout.cell(x, y) != Cell::Data) continue;
        --bit;
        EXPECT_EQ((read >> bit) & 1, cells.at(x, y) == Cell::White ? 1u : 0u) << name;
      }
    }
    EXPECT_EQ(permutation.inverse()(read), word) << name;
  }
}

TEST(BitPermutation, RefusesWhatIsNone) {
  EXPECT_THROW(BitPermutation(std::vector<int>{0, 0}), std::invalid_argument);
  EXPECT_THROW(BitPermutation(std::vector<int>{0, 2}), std::invalid_argument);
  EXPECT_THROW(BitPermutation(std::vector<int>{-1, 0}), std::invalid_argument);
  EXPECT_THROW(BitPermutation(std::vector<int>(65)), std::invalid_argument);
  EXPECT_EQ(BitPermutation(std::vector<int>{1, 2, 0})(0b011), 0b110u);
}

}  // namespace
}  // namespace tagmint::codec
