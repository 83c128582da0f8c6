// True distances of the dictionaries that the installed OpenCV has built in, from their codewords:
// the figures of docs/families.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "support/opencv_dictionaries.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/near_pairs.h"
#include "tagmint/codec/rotation.h"

namespace tagmint {
namespace {

int first_used(const std::vector<std::uint64_t>& histogram) {
  const auto used = std::find_if(histogram.begin(), histogram.end(), [](auto n) { return n > 0; });
  return static_cast<int>(used - histogram.begin());
}

struct Distances {
  int between;  ///< two tags, in any rotation
  int self;     ///< a tag and its own turns
  friend bool operator==(const Distances&, const Distances&) = default;
};

const std::map<std::string, Distances>& expected_distances() {
  static const std::map<std::string, Distances> all = {
      {"DICT_4X4_50", {4, 4}},          {"DICT_4X4_100", {3, 4}},
      {"DICT_4X4_250", {3, 4}},         {"DICT_4X4_1000", {2, 2}},
      {"DICT_5X5_50", {8, 8}},          {"DICT_5X5_100", {7, 8}},
      {"DICT_5X5_250", {6, 6}},         {"DICT_5X5_1000", {5, 6}},
      {"DICT_6X6_50", {13, 14}},        {"DICT_6X6_100", {12, 14}},
      {"DICT_6X6_250", {11, 12}},       {"DICT_6X6_1000", {9, 10}},
      {"DICT_7X7_50", {19, 20}},        {"DICT_7X7_100", {18, 20}},
      {"DICT_7X7_250", {17, 18}},       {"DICT_7X7_1000", {14, 16}},
      {"DICT_ARUCO_ORIGINAL", {1, 0}},  {"DICT_APRILTAG_16h5", {5, 6}},
      {"DICT_APRILTAG_25h9", {9, 10}},  {"DICT_APRILTAG_36h10", {10, 10}},
      {"DICT_APRILTAG_36h11", {11, 12}}};
  return all;
}

TEST(OpenCvDictionaries, TrueDistancesAreTheKnownOnes) {
  std::size_t compared = 0;
  for (const test::OpenCvDictionary& dictionary : test::opencv_dictionaries()) {
    const auto expected = expected_distances().find(dictionary.name);
    if (expected == expected_distances().end()) continue;  // of a later OpenCV
    const codec::FamilyStats stats = codec::family_stats(dictionary.family);
    const Distances found{first_used(stats.distance_histogram), first_used(stats.self_histogram)};
    EXPECT_EQ(found, expected->second)
        << dictionary.name << ": " << found.between << ", " << found.self;
    EXPECT_EQ(stats.min_hamming, std::min(found.between, found.self)) << dictionary.name;
    ++compared;
  }
  EXPECT_EQ(compared, expected_distances().size());
}

TEST(OpenCvDictionaries, OriginalOneAloneIsNearerThanItsDocumentationSays) {
  for (const test::OpenCvDictionary& dictionary : test::opencv_dictionaries()) {
    const int distance = codec::family_stats(dictionary.family).min_hamming;
    if (dictionary.name == "DICT_ARUCO_ORIGINAL") {
      EXPECT_LT(distance, dictionary.declared);
    } else {
      EXPECT_EQ(distance, dictionary.declared) << dictionary.name;
      EXPECT_LE(dictionary.corrects, (distance - 1) / 2) << dictionary.name;
    }
  }
}

TEST(OpenCvDictionaries, OriginalTagsThatLookAlikeAreNamed) {
  const auto all = test::opencv_dictionaries();
  const auto original = std::find_if(all.begin(), all.end(), [](const auto& dictionary) {
    return dictionary.name == "DICT_ARUCO_ORIGINAL";
  });
  ASSERT_NE(original, all.end());
  const codec::Family& family = original->family;
  EXPECT_EQ(codec::self_distance(family.codeword(1023), family.bits()), 0);
  const auto pairs = codec::near_pairs(family, 1, 100);
  ASSERT_EQ(pairs.size(), 5U);
  EXPECT_EQ(pairs.front().first, 255U);
  EXPECT_EQ(pairs.front().second, 1022U);
}

TEST(OpenCvDictionaries, AprilTagOnesAreTheBundledFamiliesTurnedByHalf) {
  const std::array names = {"16h5", "25h9", "36h10", "36h11"};
  std::size_t compared = 0;
  for (const test::OpenCvDictionary& dictionary : test::opencv_dictionaries()) {
    for (const std::string name : names) {
      if (dictionary.name != "DICT_APRILTAG_" + name) continue;
      const codec::SharedFamily family = codec::find_family("tag" + name);
      ASSERT_EQ(dictionary.family.size(), family->size());
      for (codec::TagId id = 0; id < family->size(); ++id) {
        EXPECT_EQ(codec::rotate(dictionary.family.codeword(id), family->bits(), 2),
                  family->codeword(id))
            << name << " id " << id;
      }
      ++compared;
    }
  }
  EXPECT_EQ(compared, names.size());
}

}  // namespace
}  // namespace tagmint
