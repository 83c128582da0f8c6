#include "draw/nested_tags.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::draw {
namespace {

using codec::find_family;

TEST(NestedTags, OnlyAWholeSquareInTheMiddleIsAHole) {
  EXPECT_EQ(hole_cells(find_family("tagCustom48h12")->layout()), 2);
  EXPECT_EQ(hole_cells(find_family("rot48")->layout()), 2);
  EXPECT_EQ(hole_cells(find_family("tag36h11")->layout()), 0);
  EXPECT_EQ(hole_cells(find_family("tagStandard41h12")->layout()), 0);
  // Round tags leave out cells at their corners, which no tag encloses.
  EXPECT_EQ(hole_cells(find_family("tagCircle49h12")->layout()), 0);
  EXPECT_EQ(hole_cells(codec::Layout("wwwwwww/wbbbbbw/wbdddbw/wbdxdbw/wbdddbw/wbbbbbw/wwwwwww")),
            1);
}

TEST(NestedTags, QuietZoneIsTheWhiteRingOrACellAround) {
  EXPECT_DOUBLE_EQ(side_with_quiet_zone(find_family("tag36h11")->layout(), 8), 10);
  EXPECT_DOUBLE_EQ(side_with_quiet_zone(find_family("tagStandard41h12")->layout(), 5), 11);
  EXPECT_DOUBLE_EQ(side_with_quiet_zone(find_family("tagCustom48h12")->layout(), 6), 12);
}

TEST(NestedTags, LargestTagFillsTheHoleWithItsQuietZone) {
  const auto host = find_family("tagCustom48h12");
  // Six cells in an edge of 600 mm: the hole of two cells has 200 mm.
  const std::vector<NestedRequest> classic = {{find_family("tag36h11"), 3, {}}};
  EXPECT_DOUBLE_EQ(nested_edges(*host, 600, classic).at(0), 160);
  const std::vector<NestedRequest> standard = {{find_family("tagStandard41h12"), 3, {}}};
  EXPECT_DOUBLE_EQ(nested_edges(*host, 600, standard).at(0), 200 * 5.0 / 11);
}

TEST(NestedTags, EachGoesIntoTheHoleOfTheOneBefore) {
  const auto host = find_family("tagCustom48h12");
  const std::vector<NestedRequest> requests = {{host, 1, 60.0}, {find_family("tag16h5"), 2, {}}};
  const std::vector<double> edges = nested_edges(*host, 600, requests);
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_DOUBLE_EQ(edges[0], 60);
  EXPECT_DOUBLE_EQ(edges[1], 20 * 6.0 / 8);
}

std::string refusal(const std::string& host, const NestedRequest& request) {
  try {
    nested_edges(*find_family(host), 600, std::vector<NestedRequest>{request});
  } catch (const DoesNotFit& fault) {
    return fault.what();
  }
  return "";
}

TEST(NestedTags, WhatDoesNotFitIsRefusedWithTheLargest) {
  EXPECT_EQ(
      refusal("tagCustom48h12", {find_family("tag36h11"), 3, 160.01}),
      "an edge of 160.01 mm is too large for the hole of tagCustom48h12: with its quiet zone "
      "the tag takes 200.012 mm, and the hole has 200 mm (tag36h11 3); leave the edge out, or "
      "take at most 160mm");
  EXPECT_EQ(refusal("tagCustom48h12", {find_family("tag36h11"), 3, 160.0}), "");
  EXPECT_EQ(refusal("tag36h11", {find_family("tag16h5"), 3, {}}),
            "tag36h11 has no hole for another tag (tag16h5 3); nest tags in a family whose layout "
            "leaves its middle out, like tagCustom48h12");
}

TEST(NestedTags, ImpossibleNumbersAreRefused) {
  const auto host = find_family("tagCustom48h12");
  const auto refused = [&](const NestedRequest& request) {
    EXPECT_THROW(nested_edges(*host, 600, std::vector<NestedRequest>{request}),
                 std::invalid_argument);
  };
  refused({find_family("tag16h5"), 30, {}});
  refused({find_family("tag16h5"), 0, 0.0});
  refused({find_family("tag16h5"), 0, -1.0});
}

}  // namespace
}  // namespace tagmint::draw
