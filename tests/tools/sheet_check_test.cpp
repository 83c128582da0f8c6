#include "draw/sheet_check.h"

#include <gtest/gtest.h>

#include <string>

#include "draw/sheet_writer.h"
#include "draw/units.h"
#include "io/images.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::draw {
namespace {

SheetPlan plan_of(std::vector<codec::TagId> ids, double edge_mm = 25) {
  return plan_sheet({{codec::find_family("tagStandard41h12"), edge_mm, std::move(ids)}},
                    {.page_width_mm = 130, .page_height_mm = 70, .margin_mm = 5});
}

ReadPage drawn(const SheetPlan& plan, double dpi, bool inverted = false) {
  SheetDecor decor{.label = {}, .title = "", .notes = false, .inverted = inverted};
  return {io::decode_gray_image(sheet_png(plan, 0, decor, dpi), "sheet"), dpi / kMmAnInch};
}

PageCheck checked(ReadPage page, const SheetPlan& plan, bool inverted = false) {
  return SheetChecker(plan.groups, inverted).check(std::move(page), plan, 0);
}

TEST(SheetCheck, WhatWasDrawnAsPlannedIsRight) {
  const SheetPlan plan = plan_of({3, 8});
  for (const double dpi : {200.0, 300.0, 437.0}) {
    const PageCheck result = checked(drawn(plan, dpi), plan);
    EXPECT_FALSE(result.fault) << result.fault->what;
    EXPECT_EQ(result.tags, 2u);
    EXPECT_LT(result.largest_error_mm, 0.05);
  }
}

TEST(SheetCheck, FewPixelsACellAreEnough) {
  const SheetPlan plan = plan_of({3, 8}, 25.4);             // cells of 5.08 mm
  const PageCheck result = checked(drawn(plan, 15), plan);  // 3 pixels
  EXPECT_FALSE(result.fault) << result.fault->what;
  EXPECT_EQ(result.tags, 2u);
}

TEST(SheetCheck, AnotherIdIsNamed) {
  const PageCheck result = checked(drawn(plan_of({3, 9}), 200), plan_of({3, 8}));
  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->family, "tagStandard41h12");
  EXPECT_EQ(result.fault->id, 8u);
  EXPECT_EQ(result.fault->what, "is not found");
  EXPECT_EQ(result.tags, 1u);
}

TEST(SheetCheck, AnotherSizeIsNamed) {
  // Half a percent too large: 0.09 mm at each side of 25 mm.
  const PageCheck result = checked(drawn(plan_of({3, 8}, 25.2), 300), plan_of({3, 8}, 25));
  ASSERT_TRUE(result.fault);
  EXPECT_NE(result.fault->what.find("mm from its place"), std::string::npos) << result.fault->what;
}

TEST(SheetCheck, AnotherPlaceIsNamed) {
  SheetPlan moved = plan_of({3, 8});
  moved.pages[0].tags[1].outer.x_mm += 0.15;
  const PageCheck result = checked(drawn(moved, 300), plan_of({3, 8}));
  ASSERT_TRUE(result.fault);
  EXPECT_EQ(result.fault->id, 8u);
}

TEST(SheetCheck, InvertedPagesAreReadInverted) {
  const SheetPlan plan = plan_of({3, 8});
  EXPECT_FALSE(checked(drawn(plan, 200, true), plan, true).fault);
  EXPECT_TRUE(checked(drawn(plan, 200, true), plan, false).fault);
}

}  // namespace
}  // namespace tagmint::draw
