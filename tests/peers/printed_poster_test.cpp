// Posters as Poppler draws their pages, put together by the plan: exact across the joints, and read
// by both detectors.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "draw/units.h"
#include "poster/poster_page.h"
#include "poster/poster_writer.h"
#include "support/camera_view.h"
#include "support/glued_poster.h"
#include "support/libapriltag_reader.h"
#include "support/measured_corners.h"
#include "support/rasterise.h"
#include "support/scratch_folder.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/tag_cells.h"
#include "tagmint/detect/detector.h"

namespace tagmint::poster {
namespace {

using codec::find_family;

// Whole pixels for all places in whole tenths of a mm; Poppler rounds edges to quarters of a pixel.
constexpr double kPixelsAMm = 10;
constexpr double kDpi = kPixelsAMm * draw::kMmAnInch;
constexpr double kMostErrorMm = 0.05;

std::string poster_pdf(const PosterPlan& plan) {
  std::string pdf;
  draw::FileOptions options;
  options.title = "a poster";
  write_poster(plan, draw::FileKind::Pdf, options, [&](std::string_view bytes) { pdf += bytes; });
  return pdf;
}

/// The pages as pictures, the map left out.
std::vector<detect::Image> printed_pages(const PosterPlan& plan, double dpi = kDpi) {
  std::vector<detect::Image> pages = test::pdf_pages(poster_pdf(plan), dpi);
  EXPECT_EQ(pages.size(), plan.pages.size() + 1);
  pages.erase(pages.begin());
  return pages;
}

detect::Corners corners_of(const draw::Box& box) {
  return {{{box.x_mm, box.bottom_mm()},
           {box.right_mm(), box.bottom_mm()},
           {box.right_mm(), box.y_mm},
           {box.x_mm, box.y_mm}}};
}

constexpr PosterOptions kA5 = {.paper_width_mm = 148, .paper_height_mm = 210};

/// Rows of both orientations: three pages upright, two turned.
PosterPlan plain_poster() { return plan_poster({find_family("tag36h11"), 5, 240.0}, {}, kA5); }

/// A tag with another in its hole.
PosterPlan nested_poster() {
  PosterOptions options = kA5;
  options.overlap_mm = 15;
  return plan_poster({find_family("tagCustom48h12"), 9, 150.5},
                     std::vector<draw::NestedRequest>{{find_family("tag36h11"), 7, {}}}, options);
}

void expect_read(const PosterTag& tag, const draw::Box& square, const detect::Image& poster) {
  const test::CameraView view;
  const detect::Image image = test::seen_by_camera(poster, view);
  const detect::Homography map = test::picture_to_image(poster, view);
  detect::Corners truth = corners_of(square);
  for (detect::Point& p : truth) p = map.project(kPixelsAMm * p);
  const auto expect = [&](const auto& found, const char* who) {
    ASSERT_EQ(found.size(), 1u) << who;
    EXPECT_EQ(found[0].id, tag.id) << who;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(length(found[0].corners[k] - truth[k]), 0.5) << who;
    }
  };
  detect::Detector detector({std::make_shared<const codec::Decoder>(
      tag.family, codec::DecoderOptions{.max_errors = 1,
                                        .allow_unsafe_radius = false,
                                        .engine = codec::DecoderEngine::Auto,
                                        .ids = {}})});
  expect(detector.detect(image), "tagmint");
  expect(test::LibapriltagReader(*tag.family).read(image), "libapriltag");
}

TEST(PrintedPoster, PutTogetherItIsReadAndExactAcrossItsJoints) {
  for (const PosterPlan& plan : {plain_poster(), nested_poster()}) {
    const detect::Image poster = test::glued_poster(plan, printed_pages(plan), kPixelsAMm);
    for (const PosterTag& tag : plan.tags) {
      SCOPED_TRACE(tag.family->name());
      const codec::Layout& layout = tag.family->layout();
      const draw::Box square = plan.border_square(tag);
      const detect::Corners planned = corners_of(square);
      const detect::Corners drawn =
          test::measured_corners(poster, kPixelsAMm, planned,
                                 tag.edge_mm / layout.width_at_border(), layout.reversed_border());
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_LT(length(drawn[k] - planned[k]), kMostErrorMm) << k;
        EXPECT_NEAR(length(drawn[(k + 1) % 4] - drawn[k]), tag.edge_mm, kMostErrorMm) << k;
      }
      expect_read(tag, square, poster);
    }
  }
}

TEST(PrintedPoster, NothingButTheTagIsOnIt) {
  const PosterPlan plan = plain_poster();
  const detect::Image poster = test::glued_poster(plan, printed_pages(plan), kPixelsAMm);
  const PosterTag& tag = plan.tags[0];
  const codec::TagCells cells =
      codec::tag_cells(tag.family->layout(), tag.family->codeword(tag.id));
  const draw::Box outer = plan.outer(tag);
  const double cell = outer.width_mm / cells.width();
  const auto black = [&](double x_px, double y_px) {
    const int x = static_cast<int>(std::floor((x_px / kPixelsAMm - outer.x_mm) / cell));
    const int y = static_cast<int>(std::floor((y_px / kPixelsAMm - outer.y_mm) / cell));
    return x >= 0 && y >= 0 && x < cells.width() && y < cells.width() &&
           cells.at(x, y) == codec::Cell::Black;
  };
  int wrong = 0;
  for (int y = 1; y + 1 < poster.height(); ++y) {
    for (int x = 1; x + 1 < poster.width(); ++x) {
      // Pixels that an edge may cross are measured elsewhere.
      const bool here = black(x + 0.5, y + 0.5);
      bool inside = true;
      for (const double dx : {-1.0, 2.0}) {
        for (const double dy : {-1.0, 2.0}) inside = inside && black(x + dx, y + dy) == here;
      }
      if (inside && poster.at(x, y) != (here ? 0 : 255)) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(PrintedPoster, NeighboursShowTheSameWhereTheyOverlap) {
  const PosterPlan plan = plain_poster();
  const std::vector<detect::Image> pages = printed_pages(plan);
  const auto gray = [&](std::size_t i, double x_mm, double y_mm) {
    const PosterPage& page = plan.pages[i];
    return int{
        pages[i].at(static_cast<int>(kPixelsAMm * (x_mm - page.part.x_mm + plan.margin_mm)),
                    static_cast<int>(kPixelsAMm * (y_mm - page.part.y_mm + plan.margin_mm)))};
  };
  int compared = 0;
  for (std::size_t i = 0; i + 1 < plan.pages.size(); ++i) {
    const draw::Box& a = plan.pages[i].part;
    const draw::Box& b = plan.pages[i + 1].part;
    if (plan.pages[i + 1].column == 0) continue;
    // Places in the middle of pixels, half a mm from the rims of the overlap, where cut lines are.
    for (double y = a.y_mm + 5.1; y < a.bottom_mm() - 5; y += 1) {
      for (double x = b.x_mm + 0.5; x < a.right_mm() - 0.5; x += 1) {
        EXPECT_NEAR(gray(i, x, y), gray(i + 1, x, y), 1) << i << ": " << x << ", " << y;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(PrintedPoster, CrossesAreDrawnWhereNeighboursMeet) {
  const PosterPlan plan = plain_poster();
  const std::vector<detect::Image> pages = printed_pages(plan);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    for (const draw::PathPoint& cross : crosses(plan, plan.pages[i])) {
      const double x = kPixelsAMm * (cross.x - plan.pages[i].part.x_mm + plan.margin_mm);
      const double y = kPixelsAMm * (cross.y - plan.pages[i].part.y_mm + plan.margin_mm);
      // A line of a tenth of a mm is half a pixel of dark gray, on one side of the place or on
      // both.
      const auto ink = [&](double at_x, double at_y) {
        int darkest = 255;
        for (const double dx : {-0.5, 0.5}) {
          for (const double dy : {-0.5, 0.5}) {
            darkest = std::min(darkest, int{pages[i].at(static_cast<int>(at_x + dx),
                                                        static_cast<int>(at_y + dy))});
          }
        }
        return darkest < 235;
      };
      EXPECT_TRUE(ink(x, y));
      EXPECT_TRUE(ink(x + 0.8 * kCrossArmMm * kPixelsAMm, y));
      EXPECT_TRUE(ink(x, y - 0.8 * kCrossArmMm * kPixelsAMm));
    }
  }
}

TEST(PrintedPoster, MapAndPagesSayWhatTheyAre) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("a.pdf", poster_pdf(nested_poster()));
  const std::string map = test::output_of("pdftotext -layout -l 1 '" + path + "' -");
  for (const char* part : {"tagCustom48h12 9: edge 150.5 mm, outer 250.833 mm",
                           "tag36h11 7 in the hole: edge 40.133 mm, outer 50.167 mm",
                           "poster with its quiet zone: 301 mm x 301 mm", "overlap 15 mm",
                           "row 1: pages 2-", "Row by row: cut the left side", "measure me"}) {
    EXPECT_NE(map.find(part), std::string::npos) << part << "\n" << map;
  }
  const std::string second = test::output_of("pdftotext -layout -f 3 -l 3 '" + path + "' -");
  EXPECT_NE(second.find("row 1 of 2, column 2 of"), std::string::npos) << second;
  EXPECT_NE(second.find("page 3 of"), std::string::npos) << second;
}

TEST(PrintedPoster, EdgeIsExactAt1200Dpi) {
  // A joint runs through the tag: two pages of A6, of which each shows a part of the border square.
  const PosterPlan plan = plan_poster(
      {find_family("tag16h5"), 3, 84.0}, {},
      {.paper_width_mm = 105, .paper_height_mm = 148, .orientation = Orientation::AsGiven});
  ASSERT_EQ(plan.pages.size(), 2u);
  const double px_a_mm = 1200 / draw::kMmAnInch;
  const std::vector<detect::Image> pages = printed_pages(plan, 1200);
  const draw::Box square = plan.border_square(plan.tags[0]);
  // The upright sides of the square, one on each page, a cell below its upper corner.
  const auto side_at = [&](std::size_t i, double x_mm, bool black_right) {
    const PosterPage& page = plan.pages[i];
    const int y = static_cast<int>((square.y_mm + 7 - page.part.y_mm + plan.margin_mm) * px_a_mm);
    const double from = (x_mm - 3 - page.part.x_mm + plan.margin_mm) * px_a_mm;
    double black = 0;
    const int first = static_cast<int>(std::floor(from));
    const int count = static_cast<int>(6 * px_a_mm);
    for (int x = first; x < first + count; ++x) black += (255 - pages[i].at(x, y)) / 255.0;
    const double edge_px = black_right ? first + count - black : first + black;
    return edge_px / px_a_mm - plan.margin_mm + page.part.x_mm;
  };
  const double left = side_at(0, square.x_mm, true);
  const double right = side_at(1, square.right_mm(), false);
  EXPECT_NEAR(left, square.x_mm, kMostErrorMm);
  EXPECT_NEAR(right - left, 84.0, kMostErrorMm);
}

#ifdef TAGMINT_HAVE_QPDF
TEST(PrintedPoster, PdfIsValid) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("a.pdf", poster_pdf(plain_poster()));
  EXPECT_NE(test::output_of("qpdf --check '" + path + "' 2>&1").find("No syntax or stream"),
            std::string::npos);
}
#endif

}  // namespace
}  // namespace tagmint::poster
