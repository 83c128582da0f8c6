#include "draw/sheet_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::draw {
namespace {

/// A family of `count` words in a layout; what the words are does not matter here.
codec::SharedFamily family_of(const std::string& layout, std::size_t count = 100) {
  std::vector<codec::Codeword> words(count);
  std::iota(words.begin(), words.end(), codec::Codeword{1});
  return std::make_shared<codec::Family>(codec::FamilyParts{.name = "test",
                                                            .layout = codec::parse_layout(layout),
                                                            .min_hamming = 1,
                                                            .codewords = words,
                                                            .complexity = {},
                                                            .origin = {},
                                                            .levels = {}});
}

std::vector<codec::TagId> first_ids(std::size_t count) {
  std::vector<codec::TagId> ids(count);
  std::iota(ids.begin(), ids.end(), codec::TagId{0});
  return ids;
}

std::string complaint(std::vector<TagGroup> groups, const SheetOptions& options) {
  try {
    plan_sheet(std::move(groups), options);
  } catch (const DoesNotFit& fault) {
    return fault.what();
  }
  return "fits";
}

TEST(SheetPlan, EdgeAndOuterDifferByTheLayout) {
  // The published families: 10/8, 9/5 (the 1.8 times confusion), 10/6.
  EXPECT_DOUBLE_EQ(outer_of_edge(codec::classic_layout(10), 40), 50);
  EXPECT_DOUBLE_EQ(outer_of_edge(codec::standard_layout(9), 50), 90);
  EXPECT_DOUBLE_EQ(edge_of_outer(codec::standard_layout(10), 50), 30);
}

TEST(SheetPlan, OnlyTagsWithoutAWhiteRingNeedAQuietZone) {
  EXPECT_EQ(quiet_cells(codec::classic_layout(10)), 0);
  EXPECT_EQ(quiet_cells(codec::standard_layout(9)), 1);
  EXPECT_EQ(quiet_cells(codec::circle_layout(9)), 1);
}

TEST(SheetPlan, TagsStandInACentredGrid) {
  // 50 mm tags, 5 mm apart, on 190 x 277 mm: 3 columns (160 mm), 5 rows (270 mm).
  const SheetPlan plan = plan_sheet({{family_of("classic:10"), 40, first_ids(15)}}, {});
  ASSERT_EQ(plan.pages.size(), 1u);
  EXPECT_EQ(plan.grids[0].columns, 3);
  EXPECT_EQ(plan.grids[0].rows, 5);
  for (std::size_t i = 0; i < 15; ++i) {
    const PlacedTag& tag = plan.pages[0].tags[i];
    EXPECT_EQ(tag.id, i);
    EXPECT_NEAR(tag.outer.x_mm, 25 + 55.0 * static_cast<double>(i % 3), 1e-9);
    EXPECT_NEAR(tag.outer.y_mm, 13.5 + 55.0 * static_cast<double>(i / 3), 1e-9);
    EXPECT_NEAR(tag.outer.width_mm, 50, 1e-9);
  }
}

TEST(SheetPlan, WhatJustFitsFits) {
  SheetOptions options{.page_width_mm = 110, .page_height_mm = 50, .margin_mm = 0, .gap_mm = 10};
  EXPECT_EQ(plan_sheet({{family_of("classic:10"), 40, first_ids(2)}}, options).grids[0].columns, 2);
  options.page_width_mm = 109.99;
  EXPECT_EQ(plan_sheet({{family_of("classic:10"), 40, first_ids(2)}}, options).grids[0].columns, 1);
}

TEST(SheetPlan, ManyTagsTakeManyPagesAtTheSamePlaces) {
  const SheetPlan plan = plan_sheet({{family_of("classic:10"), 40, first_ids(37)}}, {});
  ASSERT_EQ(plan.pages.size(), 3u);
  EXPECT_EQ(plan.tag_count(), 37u);
  EXPECT_EQ(plan.pages[2].tags.size(), 7u);
  for (const SheetPage& page : plan.pages) {
    for (std::size_t i = 0; i < page.tags.size(); ++i) {
      EXPECT_DOUBLE_EQ(page.tags[i].outer.x_mm, plan.pages[0].tags[i].outer.x_mm);
      EXPECT_DOUBLE_EQ(page.tags[i].outer.y_mm, plan.pages[0].tags[i].outer.y_mm);
    }
  }
}

TEST(SheetPlan, SlotsLieOnTheFreeAreaAndApart) {
  const SheetOptions options{
      .margin_mm = 7, .gap_mm = 3, .label_mm = 4, .header_mm = 10, .footer_mm = 12};
  const SheetPlan plan = plan_sheet({{family_of("classic:10"), 31, first_ids(17)},
                                     {family_of("standard:9"), 22, first_ids(9)},
                                     {family_of("circle:9"), 30.5, first_ids(5)}},
                                    options);
  for (const SheetPage& page : plan.pages) {
    for (std::size_t i = 0; i < page.tags.size(); ++i) {
      const Box& a = page.tags[i].slot;
      EXPECT_GE(a.x_mm, 7 - 1e-6);
      EXPECT_LE(a.right_mm(), 203 + 1e-6);
      EXPECT_GE(a.y_mm, 17 - 1e-6);
      EXPECT_LE(a.bottom_mm(), 278 + 1e-6);
      for (std::size_t k = 0; k < i; ++k) {
        const Box& b = page.tags[k].slot;
        const double apart = std::max({a.x_mm - b.right_mm(), b.x_mm - a.right_mm(),
                                       a.y_mm - b.bottom_mm(), b.y_mm - a.bottom_mm()});
        EXPECT_GE(apart, 3 - 1e-6);
      }
    }
  }
}

TEST(SheetPlan, QuietZoneIsOneCellAndTheLabelBelowIt) {
  const SheetPlan plan =
      plan_sheet({{family_of("standard:9"), 50, first_ids(1)}}, {.label_mm = 4.0});
  const PlacedTag& tag = plan.pages[0].tags[0];
  EXPECT_NEAR(tag.outer.x_mm - tag.slot.x_mm, 10, 1e-9);
  EXPECT_NEAR(tag.slot.right_mm() - tag.outer.right_mm(), 10, 1e-9);
  EXPECT_NEAR(tag.outer.y_mm - tag.slot.y_mm, 10, 1e-9);
  EXPECT_NEAR(tag.slot.bottom_mm() - tag.outer.bottom_mm(), 14, 1e-9);
}

TEST(SheetPlan, RowsAndColumnsAskedForAreKept) {
  const SheetPlan plan =
      plan_sheet({{family_of("classic:10"), 20, first_ids(10)}}, {.columns = 2, .rows = 3});
  ASSERT_EQ(plan.pages.size(), 2u);
  EXPECT_EQ(plan.pages[0].tags.size(), 6u);
  EXPECT_EQ(plan.pages[1].tags.size(), 4u);
}

TEST(SheetPlan, OneTagAloneHasAPageOfItsSize) {
  const SheetPlan classic = plan_single(family_of("classic:10"), 40, 3, {.margin_mm = 0});
  EXPECT_DOUBLE_EQ(classic.options.page_width_mm, 50);
  EXPECT_DOUBLE_EQ(classic.options.page_height_mm, 50);
  EXPECT_NEAR(classic.pages.at(0).tags.at(0).outer.x_mm, 0, 1e-9);
  EXPECT_EQ(classic.pages[0].tags[0].id, 3u);
  const SheetPlan standard =
      plan_single(family_of("standard:9"), 50, 0, {.margin_mm = 2, .label_mm = 5});
  EXPECT_DOUBLE_EQ(standard.options.page_width_mm, 114);
  EXPECT_DOUBLE_EQ(standard.options.page_height_mm, 119);
  EXPECT_THROW(plan_single(family_of("classic:10"), 5000, 0, {}), DoesNotFit);
}

TEST(SheetPlan, RefusalsSayWhatWouldFit) {
  EXPECT_EQ(complaint({{family_of("classic:10"), 200, first_ids(1)}}, {}),
            "not one tag fits on the page: it needs 250 mm of width with its quiet zone and label, "
            "and 190 mm are free (test with edge 200 mm); take a larger paper, a smaller margin or "
            "a smaller edge");
  EXPECT_NE(complaint({{family_of("classic:10"), 40, first_ids(9)}}, {.columns = 4})
                .find("they need 215 mm, and 190 mm are free (test with edge 40 mm); ask for at "
                      "most 3"),
            std::string::npos);
  EXPECT_NE(complaint({{family_of("classic:10"), 40, first_ids(9)}}, {.margin_mm = 120})
                .find("0 mm are free"),
            std::string::npos);
}

TEST(SheetPlan, ImpossibleArgumentsAreRefused) {
  const codec::SharedFamily family = family_of("classic:10", 4);
  EXPECT_THROW(plan_sheet({}, {}), std::invalid_argument);
  EXPECT_THROW(plan_sheet({{nullptr, 40, {0}}}, {}), std::invalid_argument);
  EXPECT_THROW(plan_sheet({{family, 40, {}}}, {}), std::invalid_argument);
  EXPECT_THROW(plan_sheet({{family, 0, {0}}}, {}), std::invalid_argument);
  EXPECT_THROW(plan_sheet({{family, 40, {4}}}, {}), std::invalid_argument);
  EXPECT_THROW(plan_sheet({{family, 40, {0}}}, {.page_width_mm = 1e5}), std::invalid_argument);
  EXPECT_THROW(plan_sheet({{family, 40, {0}}}, {.gap_mm = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::draw
