// Quiet zones, cut shapes, whole dots and rulers: what they are in numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "draw/cut_outline.h"
#include "draw/ruler.h"
#include "draw/sheet_bookmarks.h"
#include "draw/sheet_plan.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::draw {
namespace {

TagGroup group_of(const char* family, double edge_mm, std::size_t count) {
  TagGroup group{codec::find_family(family), edge_mm, std::vector<codec::TagId>(count)};
  std::iota(group.ids.begin(), group.ids.end(), codec::TagId{0});
  return group;
}

TEST(QuietZone, CountsTheTagsOwnWhiteRing) {
  // 8 cells in 40 mm; the tenth ring is the tag's own.
  EXPECT_DOUBLE_EQ(quiet_zone_mm(codec::classic_layout(10), 40, 1), 0);
  EXPECT_DOUBLE_EQ(quiet_zone_mm(codec::classic_layout(10), 40, 2), 5);
  EXPECT_DOUBLE_EQ(quiet_zone_mm(codec::classic_layout(10), 40, 0), 0);
  // 5 cells in 50 mm.
  EXPECT_DOUBLE_EQ(quiet_zone_mm(codec::standard_layout(9), 50, 1), 10);
  EXPECT_DOUBLE_EQ(quiet_zone_mm(codec::standard_layout(9), 50, 0.5), 5);
  const SheetPlan plan =
      plan_sheet({group_of("tagStandard41h12", 25, 1)}, {.quiet_zone_cells = 2.5});
  const PlacedTag& tag = plan.pages[0].tags[0];
  EXPECT_DOUBLE_EQ(tag.quiet_mm, 12.5);
  EXPECT_NEAR(tag.outer.x_mm - tag.slot.x_mm, 12.5, 1e-9);
  EXPECT_NEAR(tag.slot.right_mm() - tag.outer.right_mm(), 12.5, 1e-9);
}

TEST(WholeDots, RoundTheCellAndStartOnADot) {
  const codec::Layout layout = codec::classic_layout(10);
  // 5 mm a cell are 59.06 dots.
  EXPECT_NEAR(whole_dot_edge(layout, 40, 300), 8 * 59 * 25.4 / 300, 1e-12);
  EXPECT_NEAR(whole_dot_edge(layout, 40, 254), 40, 1e-12);
  EXPECT_NEAR(whole_dot_edge(layout, 0.1, 25.4), 8, 1e-12);  // never less than a dot
  const double dot = 25.4 / 300;
  TagGroup group =
      group_of("tagStandard41h12", whole_dot_edge(codec::standard_layout(9), 21, 300), 9);
  const SheetPlan plan = plan_sheet({group}, {.gap_mm = 3.3, .dot_mm = dot});
  for (const PlacedTag& tag : plan.pages[0].tags) {
    for (const double at : {tag.outer.x_mm, tag.outer.y_mm, tag.outer.right_mm()}) {
      EXPECT_NEAR(at / dot, std::round(at / dot), 1e-6);
    }
  }
}

/// The least distance that an outline keeps from a rectangle, negative where it enters.
double distance_outside(const Path& outline, const Box& box) {
  double least = 1e9;
  for (const Polyline& line : flattened(outline, 1e-3)) {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const PathPoint a = line.points[i];
      const PathPoint b = line.points[(i + 1) % line.points.size()];
      for (int step = 0; step <= 20; ++step) {
        const double x = a.x + (b.x - a.x) * step / 20;
        const double y = a.y + (b.y - a.y) * step / 20;
        const double dx = std::max(box.x_mm - x, x - box.right_mm());
        const double dy = std::max(box.y_mm - y, y - box.bottom_mm());
        least = std::min(least, std::max(dx, dy));
      }
    }
  }
  return least;
}

TEST(CutOutline, StaysInTheGap) {
  for (const CutShape shape : {CutShape::Square, CutShape::Rounded}) {
    for (const double gap : {kCutGapMm, 2.0, 10.0}) {
      const SheetPlan plan = plan_sheet({group_of("tagStandard41h12", 15, 4)},
                                        {.gap_mm = gap, .label_mm = 3, .cut_shape = shape});
      for (const PlacedTag& tag : plan.pages[0].tags) {
        const Path outline = cut_outline(tag, codec::standard_layout(9), shape, gap);
        EXPECT_GT(distance_outside(outline, tag.slot), kCutLineMm / 2 - 1e-9) << gap;
        // And leaves as much to the neighbour's half of the gap.
        const PathBounds box = bounds(outline);
        EXPECT_LT(tag.slot.x_mm - box.left, gap / 2 - kCutLineMm / 2 + 1e-9) << gap;
        EXPECT_LT(box.bottom - tag.slot.bottom_mm(), gap / 2 - kCutLineMm / 2 + 1e-9) << gap;
      }
    }
  }
}

TEST(CutOutline, ACircleGoesAroundTagAndQuietZone) {
  const codec::Layout layout = codec::circle_layout(9);
  const SheetPlan plan = plan_sheet({group_of("tagCircle21h7", 25, 2)},
                                    {.gap_mm = 2, .label_mm = 3, .cut_shape = CutShape::Circle});
  const double cell = 5.0;
  // The farthest cells of circle:9 end 4.5 cells right of and 2.5 cells below the middle, or less.
  EXPECT_GT(radius_cells(layout), 4.5);
  EXPECT_LT(radius_cells(layout), std::hypot(4.5, 4.5));
  for (const PlacedTag& tag : plan.pages[0].tags) {
    const PathPoint middle{tag.outer.x_mm + tag.outer.width_mm / 2,
                           tag.outer.y_mm + tag.outer.height_mm / 2};
    const Path circle = cut_outline(tag, layout, CutShape::Circle, 2);
    for (const Polyline& line : flattened(circle, 1e-3)) {
      for (const PathPoint& point : line.points) {
        const double radius = std::hypot(point.x - middle.x, point.y - middle.y);
        EXPECT_GT(radius, (radius_cells(layout) + 1) * cell + kCutLineMm / 2);
        EXPECT_LT(radius, (radius_cells(layout) + 1) * cell + 2 * kCutLineMm);
      }
    }
  }
  const PlacedTag& first = plan.pages[0].tags[0];
  const PlacedTag& second = plan.pages[0].tags[1];
  EXPECT_GE(second.slot.x_mm - first.slot.x_mm, 2 * (radius_cells(layout) + 1) * cell + 2);
}

TEST(Ruler, IsAtLeast100MillimetresWhereverPaperAllows) {
  EXPECT_EQ(ruler_length_mm(190), 150);
  EXPECT_EQ(ruler_length_mm(128), 120);
  EXPECT_EQ(ruler_length_mm(104.8), 100);
  EXPECT_EQ(ruler_length_mm(104.7), 90);
  EXPECT_EQ(ruler_length_mm(9), 0);
  EXPECT_EQ(ruler_place({0, 0, 190, 277}), RulerPlace::Lying);
  EXPECT_EQ(ruler_place({0, 0, 85, 128}), RulerPlace::Upright);  // a6 with its margins
  EXPECT_EQ(ruler_place({0, 0, 50, 50}), RulerPlace::Lying);
  EXPECT_EQ(ruler_place({0, 0, 9, 9}), RulerPlace::None);
}

TEST(SheetBookmarks, NameIdsInRanges) {
  using Ids = std::vector<codec::TagId>;
  EXPECT_EQ(id_text(Ids{0, 1, 2, 3}), "0-3");
  EXPECT_EQ(id_text(Ids{3, 7, 9, 10}), "3, 7, 9-10");
  EXPECT_EQ(id_text(Ids{1, 3, 5, 7, 9, 11}), "1 to 11 (6 ids)");
}

TEST(SheetBookmarks, LeadToEachGroupAndPage) {
  const SheetPlan plan = plan_sheet({group_of("tag36h11", 40, 16), group_of("tag16h5", 20, 3)}, {});
  ASSERT_EQ(plan.pages.size(), 2u);
  const auto first = page_bookmarks(plan, 0);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].title, "tag36h11: edge 40 mm, outer 50 mm");
  EXPECT_EQ(first[0].level, 0);
  EXPECT_EQ(first[1].title, "0-14");
  EXPECT_EQ(first[1].level, 1);
  const auto second = page_bookmarks(plan, 1);
  ASSERT_EQ(second.size(), 3u);
  EXPECT_EQ(second[0].title, "15");
  EXPECT_EQ(second[1].title, "tag16h5: edge 20 mm, outer 26.667 mm");
  EXPECT_EQ(second[2].title, "0-2");
  EXPECT_EQ(page_contents(plan, 1), (std::vector<std::string>{"tag36h11 15", "tag16h5 0-2"}));
}

}  // namespace
}  // namespace tagmint::draw
