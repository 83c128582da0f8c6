#include "poster/poster_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "tagmint/codec/builtin_families.h"

namespace tagmint::poster {
namespace {

using codec::find_family;

PosterPlan poster(const std::string& family, double edge, const PosterOptions& options) {
  return plan_poster({find_family(family), 5, edge}, {}, options);
}

TEST(PosterPlan, WholeQuietZoneIsPartOfThePoster) {
  EXPECT_DOUBLE_EQ(poster("tag36h11", 400, {}).side_mm, 500);
  EXPECT_DOUBLE_EQ(poster("tagStandard41h12", 400, {}).side_mm, 880);
  const PosterPlan plan = poster("tagStandard41h12", 400, {});
  EXPECT_DOUBLE_EQ(plan.border_square(plan.tags[0]).x_mm, 240);
  EXPECT_DOUBLE_EQ(plan.outer(plan.tags[0]).x_mm, 80);
}

/// Each page shares `overlap` with its neighbours on the left and above, and all together hold the
/// poster.
void expect_covered(const PosterPlan& plan, double overlap) {
  std::size_t row_begin = 0;
  double bottom = 0;  // of the row above
  for (int row = 0; row < plan.rows(); ++row) {
    const std::size_t columns = static_cast<std::size_t>(plan.columns[row]);
    const PosterPage& first = plan.pages[row_begin];
    const PosterPage& last = plan.pages[row_begin + columns - 1];
    EXPECT_LE(first.part.x_mm, 1e-6);
    // What is left over is shared by both sides.
    EXPECT_NEAR(-first.part.x_mm, last.part.right_mm() - plan.side_mm, 1e-9);
    for (std::size_t column = 0; column < columns; ++column) {
      const PosterPage& page = plan.pages[row_begin + column];
      EXPECT_EQ(page.row, row);
      EXPECT_EQ(page.column, static_cast<int>(column));
      EXPECT_DOUBLE_EQ(page.part.y_mm, first.part.y_mm);
      if (column > 0) {
        EXPECT_NEAR(plan.pages[row_begin + column - 1].part.right_mm() - page.part.x_mm, overlap,
                    1e-9);
      }
    }
    if (row == 0) {
      EXPECT_LE(first.part.y_mm, 1e-6);
    } else {
      EXPECT_NEAR(bottom - first.part.y_mm, overlap, 1e-9);
    }
    bottom = first.part.bottom_mm();
    row_begin += columns;
  }
  EXPECT_EQ(row_begin, plan.pages.size());
  EXPECT_NEAR(-plan.pages[0].part.y_mm, bottom - plan.side_mm, 1e-9);
  EXPECT_GE(bottom, plan.side_mm - 1e-6);
}

TEST(PosterPlan, PagesOverlapByWhatWasAskedAndCoverThePoster) {
  const PosterPlan plan = poster("tag36h11", 400, {.margin_mm = 8, .overlap_mm = 12});
  // A4 with 194 x 281 mm printed; 500 mm takes ceil(488 / 182) = 3 by ceil(488 / 269) = 2.
  EXPECT_EQ(plan.columns, (std::vector<int>{3, 3}));
  EXPECT_DOUBLE_EQ(plan.pages[0].part.width_mm, 194);
  EXPECT_DOUBLE_EQ(plan.pages[0].part.height_mm, 281);
  EXPECT_DOUBLE_EQ(plan.page_width_mm(plan.pages[0]), 210);
  expect_covered(plan, 12);
}

TEST(PosterPlan, RowsOfBothOrientationsWhereTheySavePages) {
  // 450 mm take 3 x 2 pages of A4 upright or 2 x 3 turned, but 3 upright and 2 turned will do:
  // 277 + 190 - 10 mm high.
  PosterOptions options;
  const PosterPlan mixed = poster("tag36h11", 360, options);
  EXPECT_EQ(mixed.columns, (std::vector<int>{3, 2}));
  EXPECT_DOUBLE_EQ(mixed.page_width_mm(mixed.pages[0]), 210);
  EXPECT_DOUBLE_EQ(mixed.page_width_mm(mixed.pages[4]), 297);
  expect_covered(mixed, 10);
  options.orientation = Orientation::AsGiven;
  EXPECT_EQ(poster("tag36h11", 360, options).columns, (std::vector<int>{3, 3}));
  options.orientation = Orientation::Turned;
  EXPECT_EQ(poster("tag36h11", 360, options).columns, (std::vector<int>{2, 2, 2}));
}

TEST(PosterPlan, NeverMorePagesThanEitherOrientation) {
  for (const double edge : {20.0, 100.0, 250.0, 333.3, 700.0, 1234.0}) {
    PosterOptions options;
    options.orientation = Orientation::AsGiven;
    const std::size_t as_given = poster("tag36h11", edge, options).pages.size();
    options.orientation = Orientation::Turned;
    EXPECT_EQ(poster("tag36h11", edge, options).pages.size(), as_given);
    options.orientation = Orientation::FewestPages;
    const PosterPlan fewest = poster("tag36h11", edge, options);
    EXPECT_LE(fewest.pages.size(), as_given);
    expect_covered(fewest, 10);
  }
}

TEST(PosterPlan, OneMoreMicrometreTakesOneMoreColumn) {
  // Two pages of 190 mm that share 10 mm hold 370 mm.
  PosterOptions options{.paper_width_mm = 210, .paper_height_mm = 1000};
  options.orientation = Orientation::AsGiven;
  EXPECT_EQ(poster("tag36h11", 0.8 * 370, options).columns, (std::vector<int>{2}));
  EXPECT_EQ(poster("tag36h11", 0.8 * 370.001, options).columns, (std::vector<int>{3}));
}

TEST(PosterPlan, WhitePagesAreCountedAndMarked) {
  // Large round tags: pages at the corners hold no cell of the tag.
  const PosterPlan plan =
      poster("tagCircle49h12", 500, {.paper_width_mm = 105, .paper_height_mm = 148});
  EXPECT_TRUE(plan.pages.front().all_white);
  EXPECT_TRUE(plan.pages.back().all_white);
  EXPECT_FALSE(plan.pages[plan.pages.size() / 2].all_white);
  expect_covered(plan, 10);
}

TEST(PosterPlan, NestedTagsStandInTheMiddle) {
  const std::vector<draw::NestedRequest> nested = {{find_family("tag36h11"), 7, {}}};
  const PosterPlan plan = plan_poster({find_family("tagCustom48h12"), 5, 600}, nested, {});
  ASSERT_EQ(plan.tags.size(), 2u);
  EXPECT_EQ(plan.tags[1].id, 7u);
  EXPECT_DOUBLE_EQ(plan.tags[1].edge_mm, 160);
  EXPECT_DOUBLE_EQ(plan.side_mm, 1200);
  EXPECT_DOUBLE_EQ(plan.border_square(plan.tags[1]).x_mm, 520);
}

TEST(PosterPlan, ImpossiblePostersAreRefused) {
  const auto refusal = [](const PosterOptions& options, double edge) -> std::string {
    try {
      poster("tag36h11", edge, options);
    } catch (const draw::DoesNotFit& fault) {
      return fault.what();
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "";
  };
  EXPECT_EQ(
      refusal({.margin_mm = 5}, 400),
      "a margin in mm of 5 cannot be; it is at least 6, for the marks and page numbers in it");
  EXPECT_EQ(refusal({.overlap_mm = 96}, 400),
            "margins of 10 mm and an overlap of 96 mm leave too little of the paper (210 mm x 297 "
            "mm); take a larger paper, a smaller margin or a smaller overlap");
  EXPECT_NE(refusal({.margin_mm = 105, .overlap_mm = 0}, 400), "");
  EXPECT_NE(refusal({.overlap_mm = -1}, 400), "");
  EXPECT_NE(refusal({}, 0), "");
  EXPECT_NE(refusal({}, 1e6), "");
  EXPECT_THROW(plan_poster({find_family("tag36h11"), 587, 400}, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::poster
