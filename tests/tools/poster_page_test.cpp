#include "poster/poster_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::poster {
namespace {

using codec::find_family;
using draw::PathPoint;

PosterPlan mixed_rows() { return plan_poster({find_family("tag36h11"), 5, 360.0}, {}, {}); }

/// Area that a path of polygons covers; holes run the other way round.
double area(const draw::Path& path) {
  double sum = 0;
  for (const draw::Polyline& polygon : draw::flattened(path, 0.1)) {
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const PathPoint a = polygon.points[i];
      const PathPoint b = polygon.points[(i + 1) % polygon.points.size()];
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
  }
  return sum;
}

/// Area of the black cells inside a page's part, cell by cell.
double black_area(const PosterPlan& plan, const PosterPage& page, const PosterTag& tag) {
  const codec::TagCells cells =
      codec::tag_cells(tag.family->layout(), tag.family->codeword(tag.id));
  const draw::Box outer = plan.outer(tag);
  const double cell = outer.width_mm / cells.width();
  double sum = 0;
  for (int y = 0; y < cells.width(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (cells.at(x, y) != codec::Cell::Black) continue;
      const double left = std::max(outer.x_mm + x * cell, page.part.x_mm);
      const double right = std::min(outer.x_mm + (x + 1) * cell, page.part.right_mm());
      const double top = std::max(outer.y_mm + y * cell, page.part.y_mm);
      const double bottom = std::min(outer.y_mm + (y + 1) * cell, page.part.bottom_mm());
      sum += std::max(right - left, 0.0) * std::max(bottom - top, 0.0);
    }
  }
  return sum;
}

TEST(PosterPage, BlackIsCutOffAtThePrintedPart) {
  for (const double edge : {360.0, 333.3, 77.7}) {
    const PosterPlan plan = plan_poster({find_family("tagStandard41h12"), 5, edge}, {}, {});
    for (const PosterPage& page : plan.pages) {
      const draw::Path path = black_on_page(plan, page, plan.tags[0]);
      EXPECT_NEAR(area(path), black_area(plan, page, plan.tags[0]), 1e-6);
      EXPECT_EQ(path.empty(), page.all_white);
      if (path.empty()) continue;
      const draw::PathBounds box = draw::bounds(path);
      EXPECT_GE(box.left, plan.margin_mm - 1e-9);
      EXPECT_GE(box.top, plan.margin_mm - 1e-9);
      EXPECT_LE(box.right, plan.margin_mm + page.part.width_mm + 1e-9);
      EXPECT_LE(box.bottom, plan.margin_mm + page.part.height_mm + 1e-9);
    }
  }
}

TEST(PosterPage, NeighboursHaveTheSameCrosses) {
  std::map<std::pair<long, long>, int> pages_with;  // by place in um
  const PosterPlan plan = mixed_rows();
  for (const PosterPage& page : plan.pages) {
    for (const PathPoint& cross : crosses(plan, page)) {
      ++pages_with[{std::lround(1000 * cross.x), std::lround(1000 * cross.y)}];
    }
  }
  // Two at each of the two upright joints of the first row, the one of the second, and the lying
  // joint between them.
  EXPECT_EQ(pages_with.size(), 8u);
  for (const auto& [place, pages] : pages_with) EXPECT_EQ(pages, 2) << place.first;
}

TEST(PosterPage, CrossesStandOnThePaperButOutsideWhatIsSeen) {
  for (const PosterPlan& plan : {mixed_rows(), plan_poster({find_family("tag36h11"), 5, 700.0}, {},
                                                           {.margin_mm = 6, .overlap_mm = 0})}) {
    for (const PosterPage& page : plan.pages) {
      const draw::Box& part = page.part;
      for (const PathPoint& cross : crosses(plan, page)) {
        EXPECT_GE(cross.x - kCrossArmMm, part.x_mm - plan.margin_mm);
        EXPECT_LE(cross.x + kCrossArmMm, part.right_mm() + plan.margin_mm);
        EXPECT_GE(cross.y - kCrossArmMm, part.y_mm - plan.margin_mm);
        EXPECT_LE(cross.y + kCrossArmMm, part.bottom_mm() + plan.margin_mm);
        const bool beside_poster =
            cross.x + kCrossArmMm < 0 || cross.x - kCrossArmMm > plan.side_mm;
        const bool beside_part =
            cross.y + kCrossArmMm < part.y_mm || cross.y - kCrossArmMm > part.bottom_mm();
        EXPECT_TRUE(beside_poster || beside_part);
      }
    }
  }
}

}  // namespace
}  // namespace tagmint::poster
