// Sheets as other programs draw them: Poppler the PDF, librsvg the SVG.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "draw/sheet_writer.h"
#include "draw/units.h"
#include "support/rasterise.h"
#include "support/scratch_folder.h"
#include "support/sheet_measure.h"
#include "support/sheet_samples.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::draw {
namespace {

using test::measure_page;
using test::output_of;
using test::pdf_pages;
using test::sample_sheet;
using test::SampleSheet;
using test::ScratchFolder;
using test::SheetMeasures;
using test::svg_picture;

struct Sample {
  const char* family;
  double edge_mm;
  std::size_t count;
};

// One of each kind of layout, also at sizes that are no whole pixels.
const std::vector<Sample> kSamples = {{"tag36h11", 40.0, 13},         {"tag25h9", 33.3, 9},
                                      {"tagStandard41h12", 21.0, 10}, {"tagCircle21h7", 27.7, 7},
                                      {"tagCustom48h12", 30.0, 6},    {"tag16h5", 11.9, 30}};

void expect_right(const SheetMeasures& m, std::size_t tags, const std::string& what) {
  EXPECT_EQ(static_cast<std::size_t>(m.tags), tags) << what;
  EXPECT_EQ(m.wrong_cells, 0) << what;
  EXPECT_GT(m.edges, 50) << what;
  EXPECT_LT(m.largest_error_mm, 0.1) << what;
  EXPECT_EQ(m.gray_in_black, 0) << what;
  EXPECT_EQ(m.ink_in_quiet, 0) << what;
  EXPECT_EQ(static_cast<std::size_t>(m.labels), tags) << what;
  EXPECT_EQ(m.ink_at_labels_rim, 0) << what;
}

TEST(PrintedSheet, PdfHasEveryEdgeWithinATenthOfAMillimetre) {
  double largest = 0;
  for (const Sample& sample : kSamples) {
    const SampleSheet sheet = sample_sheet(sample.family, sample.edge_mm, sample.count);
    const auto pages = pdf_pages(sheet_pdf(sheet.plan, sheet.decor, "test"), 300);
    ASSERT_EQ(pages.size(), sheet.plan.pages.size()) << sample.family;
    for (std::size_t page = 0; page < pages.size(); ++page) {
      // 210 x 297 mm at 300 dpi; Poppler rounds up.
      EXPECT_NEAR(pages[page].width(), 2480.3, 1.0);
      EXPECT_NEAR(pages[page].height(), 3507.9, 1.0);
      const SheetMeasures m = measure_page(pages[page], 300, sheet.plan, page);
      expect_right(m, sheet.plan.pages[page].tags.size(),
                   fmt::format("{} page {}", sample.family, page + 1));
      largest = std::max(largest, m.largest_error_mm);
    }
  }
  RecordProperty("largest_error_um", static_cast<int>(std::lround(1000 * largest)));
}

TEST(PrintedSheet, SvgHasEveryEdgeWithinATenthOfAMillimetre) {
  double largest = 0;
  for (const Sample& sample : kSamples) {
    const SampleSheet sheet = sample_sheet(sample.family, sample.edge_mm, sample.count);
    for (std::size_t page = 0; page < sheet.plan.pages.size(); ++page) {
      const detect::Image picture = svg_picture(sheet_svg(sheet.plan, page, sheet.decor), 300);
      EXPECT_NEAR(picture.width(), 2480.3, 1.0);
      EXPECT_NEAR(picture.height(), 3507.9, 1.0);
      const SheetMeasures m = measure_page(picture, 300, sheet.plan, page);
      expect_right(m, sheet.plan.pages[page].tags.size(),
                   fmt::format("{} page {}", sample.family, page + 1));
      largest = std::max(largest, m.largest_error_mm);
    }
  }
  RecordProperty("largest_error_um", static_cast<int>(std::lround(1000 * largest)));
}

TEST(PrintedSheet, NoSeamsAtOddZooms) {
  const SampleSheet sheet = sample_sheet("tagStandard41h12", 23.7, 9);
  const std::string pdf = sheet_pdf(sheet.plan, sheet.decor, "test");
  const std::string svg = sheet_svg(sheet.plan, 0, sheet.decor);
  for (const double dpi : {53.0, 97.0, 131.0, 211.0}) {
    EXPECT_EQ(measure_page(pdf_pages(pdf, dpi).at(0), dpi, sheet.plan, 0).gray_in_black, 0) << dpi;
    EXPECT_EQ(measure_page(svg_picture(svg, dpi), dpi, sheet.plan, 0).gray_in_black, 0) << dpi;
  }
}

TEST(PrintedSheet, OneFileATagIsAsLargeAsTheTag) {
  const codec::SharedFamily family = codec::find_family("tagCustom48h12");
  const SheetPlan plan = plan_single(family, 60, 4, {.margin_mm = 0});
  const SheetDecor bare{.label = {}, .title = "", .notes = false};
  // Ten cells and the quiet zone of one on each side, 10 mm each.
  const detect::Image svg = svg_picture(sheet_svg(plan, 0, bare), 254);
  EXPECT_EQ(svg.width(), 1200);
  EXPECT_EQ(svg.height(), 1200);
  EXPECT_LT(measure_page(svg, 254, plan, 0).largest_error_mm, 0.1);
  EXPECT_EQ(measure_page(svg, 254, plan, 0).wrong_cells, 0);
  const auto pages = pdf_pages(sheet_pdf(plan, bare, "test"), 254);
  ASSERT_EQ(pages.size(), 1u);
  EXPECT_LT(measure_page(pages[0], 254, plan, 0).largest_error_mm, 0.1);
}

TEST(PrintedSheet, PdfTellsItsTitleAndPageSize) {
  const ScratchFolder folder;
  const SampleSheet sheet = sample_sheet("tag36h11", 40, 25);
  const std::string path =
      folder.write("a.pdf", sheet_pdf(sheet.plan, sheet.decor, "tags of the lab"));
  const std::string info = output_of("pdfinfo '" + path + "'");
  EXPECT_NE(info.find("tags of the lab"), std::string::npos) << info;
  EXPECT_NE(info.find("595.276 x 841.89 pts (A4)"), std::string::npos) << info;
  EXPECT_NE(info.find(fmt::format("Pages:           {}\n", sheet.plan.pages.size())),
            std::string::npos)
      << info;
}

TEST(PrintedSheet, LabelsStandInTheOrderOfTheIds) {
  const ScratchFolder folder;
  const SampleSheet sheet = sample_sheet("tag25h9", 30, 35);
  const std::string path = folder.write("a.pdf", sheet_pdf(sheet.plan, sheet.decor, "test"));
  const std::string text = output_of("pdftotext -layout '" + path + "' -");
  std::size_t at = 0;
  for (int id = 0; id < 35; ++id) {
    at = text.find(fmt::format("tag25h9 {:05}", id), at);
    ASSERT_NE(at, std::string::npos) << id << "\n" << text;
  }
  EXPECT_NE(text.find("tag25h9: edge 30 mm, outer 38.571 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("Sample & <title>"), std::string::npos) << text;
}

#ifdef TAGMINT_HAVE_QPDF
TEST(PrintedSheet, PdfIsValid) {
  const ScratchFolder folder;
  const SampleSheet sheet = sample_sheet("tag36h11", 40, 25);
  const std::string path = folder.write("a.pdf", sheet_pdf(sheet.plan, sheet.decor, "test"));
  EXPECT_NE(output_of("qpdf --check '" + path + "' 2>&1").find("No syntax or stream"),
            std::string::npos);
}
#endif

#ifdef TAGMINT_HAVE_XMLLINT
TEST(PrintedSheet, SvgIsWellFormed) {
  const ScratchFolder folder;
  const SampleSheet sheet = sample_sheet("tag36h11", 40, 12);
  const std::string path = folder.write("a.svg", sheet_svg(sheet.plan, 0, sheet.decor));
  EXPECT_EQ(output_of("xmllint --nonet --noout '" + path + "' 2>&1"), "");
}
#endif

}  // namespace
}  // namespace tagmint::draw
