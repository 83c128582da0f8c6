// Codes of systems older than AprilTag, from their constructions.
#include "io/family_kinds/older_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "io/family_kinds/data_square.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::io {
namespace {

using codec::Codeword;

codec::Family system_named(const std::string& name) {
  auto found = find_older_system(name, {});
  if (!found) throw std::invalid_argument(name);
  return std::move(found->family);
}

/// The cells of a tag row by row, the first one in the most significant bit.
Codeword rows_of(const codec::Family& family, codec::TagId id) {
  return DataSquare(family.layout()).rows_of(family.codeword(id));
}

/// Least distance of tags to their own turns, and between two tags.
std::pair<int, int> distances_of(const std::string& name) {
  const codec::FamilyStats stats = codec::family_stats(system_named(name));
  const auto first = [](const auto& histogram) {
    return static_cast<int>(
        std::find_if(histogram.begin(), histogram.end(), [](auto n) { return n > 0; }) -
        histogram.begin());
  };
  return {first(stats.self_histogram), first(stats.distance_histogram)};
}

TEST(OlderSystems, KnownWordsComeOut) {
  const codec::Family aruco = system_named("aruco-original");
  EXPECT_EQ(rows_of(aruco, 0), 0x1084210U);
  EXPECT_EQ(rows_of(aruco, 1), 0x1084217U);
  EXPECT_EQ(rows_of(aruco, 2), 0x1084209U);
  EXPECT_EQ(rows_of(system_named("artoolkitplus-simple"), 0), 0x6dc269c27U);
  EXPECT_EQ(rows_of(system_named("artoolkitplus-bch"), 0), 0x8f80b8750U);
  // The id whose message is 0.
  EXPECT_EQ(rows_of(system_named("artag"), 0b1010101010), 0U);
}

TEST(OlderSystems, SizesAndTrueDistancesAreTheKnownOnes) {
  EXPECT_EQ(system_named("artoolkitplus-simple").size(), 512U);
  EXPECT_EQ(system_named("artoolkitplus-bch").size(), 4096U);
  EXPECT_EQ(system_named("artag").size(), 1024U);
  EXPECT_EQ(system_named("aruco-original").size(), 1024U);
  EXPECT_EQ(distances_of("artoolkitplus-simple"), (std::pair{10, 4}));
  EXPECT_EQ(distances_of("artoolkitplus-bch"), (std::pair{4, 2}));
  EXPECT_EQ(distances_of("artag"), (std::pair{0, 4}));
  EXPECT_EQ(distances_of("aruco-original"), (std::pair{0, 1}));
}

TEST(OlderSystems, MatrixTagsTellTheirTurnByThreeCorners) {
  for (const char* name :
       {"artoolkit-4x4", "artoolkit-4x4-bch-13-9-3", "artoolkit-4x4-bch-13-5-5"}) {
    const codec::Family family = system_named(name);
    EXPECT_EQ(family.layout().width_at_border(), 8);
    for (codec::TagId id = 0; id < family.size(); ++id) {
      const Codeword rows = rows_of(family, id);
      EXPECT_EQ(rows >> 15 & 1, 0U);  // top left: black
      EXPECT_EQ(rows >> 3 & 1, 0U);   // bottom left: black
      EXPECT_EQ(rows & 1, 1U);        // bottom right: white
    }
  }
  EXPECT_EQ(system_named("artoolkit-4x4").size(), 8192U);
  EXPECT_EQ(system_named("artoolkit-4x4-bch-13-9-3").size(), 512U);
  EXPECT_EQ(system_named("artoolkit-4x4-bch-13-5-5").size(), 32U);
  // id 1: the last free cell, left of the bottom right corner, is the only black one of them.
  EXPECT_EQ(rows_of(system_named("artoolkit-4x4"), 1), 0xffffU & ~0x800aU);
}

TEST(OlderSystems, MatrixCodesKeepTheirDistanceAsWritten) {
  for (const auto& [name, distance] :
       {std::pair{"artoolkit-4x4-bch-13-9-3", 3}, std::pair{"artoolkit-4x4-bch-13-5-5", 5}}) {
    const codec::Family family = system_named(name);
    int least = 16;
    for (codec::TagId a = 0; a < family.size(); ++a) {
      for (codec::TagId b = 0; b < a; ++b) {
        least = std::min(least, codec::hamming_distance(family.codeword(a), family.codeword(b)));
      }
    }
    EXPECT_EQ(least, distance) << name;
  }
}

TEST(OlderSystems, BorderMayBeAnother) {
  const auto thick =
      find_older_system("artoolkitplus-simple", {.name = "thick", .layout = square_layout(6, 3)});
  ASSERT_TRUE(thick);
  EXPECT_EQ(thick->family.name(), "thick");
  EXPECT_EQ(thick->family.layout().width_at_border(), 12);
  EXPECT_THROW(find_older_system("artag", {.layout = codec::parse_layout("classic:8")}),
               std::invalid_argument);
  EXPECT_FALSE(find_older_system("tag36h11", {}));
}

}  // namespace
}  // namespace tagmint::io
