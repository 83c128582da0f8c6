#include "draw/sheet_writer.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "io/images.h"
#include "support/sheet_measure.h"
#include "support/sheet_samples.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::draw {
namespace {

using test::measure_page;
using test::sample_sheet;
using test::SampleSheet;
using test::SheetMeasures;

detect::Image picture(const SampleSheet& sheet, double dpi) {
  return io::decode_gray_image(sheet_png(sheet.plan, 0, sheet.decor, dpi), "sheet");
}

TEST(SheetWriter, PngShowsEveryTagAtItsPlace) {
  for (const auto& [family, edge_mm] :
       {std::pair{"tag36h11", 40.0}, {"tagStandard41h12", 21.3}, {"tagCircle21h7", 25.0}}) {
    const SampleSheet sheet = sample_sheet(family, edge_mm, 6);
    const SheetMeasures m = measure_page(picture(sheet, 150), 150, sheet.plan, 0);
    EXPECT_EQ(m.tags, 6) << family;
    EXPECT_EQ(m.wrong_cells, 0) << family;
    // A gray level of a pixel, and Cairo's 1/256 pixel.
    EXPECT_LT(m.largest_error_mm, 0.01) << family;
    EXPECT_EQ(m.ink_in_quiet, 0) << family;
    EXPECT_EQ(m.labels, 6) << family;
    EXPECT_EQ(m.ink_at_labels_rim, 0) << family;
  }
}

TEST(SheetWriter, NoSeamsAtOddResolutions) {
  const SampleSheet sheet = sample_sheet("tagCustom48h12", 23.7, 6);
  for (const double dpi : {61.0, 97.0, 211.0}) {
    EXPECT_EQ(measure_page(picture(sheet, dpi), dpi, sheet.plan, 0).gray_in_black, 0) << dpi;
  }
}

TEST(SheetWriter, PngHasTheSizeOfThePage) {
  const SampleSheet sheet = sample_sheet("tag16h5", 30, 1);
  const std::string png = sheet_png(sheet.plan, 0, sheet.decor, 254);
  const detect::Image image = io::decode_gray_image(png, "sheet");
  EXPECT_EQ(image.width(), 2100);
  EXPECT_EQ(image.height(), 2970);
  // 254 dpi = 10000 = 0x2710 pixels a metre.
  EXPECT_NE(png.find(std::string("pHYs\x00\x00\x27\x10\x00\x00\x27\x10\x01", 13)),
            std::string::npos);
}

TEST(SheetWriter, PngsTooLargeAreRefused) {
  const SampleSheet sheet = sample_sheet("tag16h5", 30, 1);
  EXPECT_THROW(sheet_png(sheet.plan, 0, sheet.decor, 9000), codec::OutputError);
}

TEST(SheetWriter, OneTagAloneIsNothingButTheTag) {
  const codec::SharedFamily family = codec::find_family("tagStandard41h12");
  const SheetPlan plan = plan_single(family, 50, 7, {.margin_mm = 0});
  // 10 mm a cell, one pixel a mm: 11 cells with the quiet zone.
  const detect::Image image = io::decode_gray_image(
      sheet_png(plan, 0, {.label = {}, .title = "", .notes = false}, 25.4), "tag");
  ASSERT_EQ(image.width(), 110);
  const codec::TagCells cells = codec::tag_cells(family->layout(), family->codeword(7));
  for (int y = 0; y < 110; ++y) {
    for (int x = 0; x < 110; ++x) {
      const bool inside = x >= 10 && y >= 10 && x < 100 && y < 100;
      const bool black = inside && cells.at(x / 10 - 1, y / 10 - 1) == codec::Cell::Black;
      ASSERT_EQ(image.at(x, y), black ? 0 : 255) << x << ", " << y;
    }
  }
}

TEST(SheetWriter, SvgGivesItsSizeInMillimetres) {
  const SampleSheet sheet = sample_sheet("tag36h11", 40, 3);
  const std::string svg = sheet_svg(sheet.plan, 0, sheet.decor);
  EXPECT_NE(svg.find("width=\"210mm\""), std::string::npos);
  EXPECT_NE(svg.find("height=\"297mm\""), std::string::npos);
  EXPECT_NE(svg.find("viewBox=\"0 0 210 297\""), std::string::npos);
}

TEST(SheetWriter, TheSameSheetIsTheSameFile) {
  const SampleSheet sheet = sample_sheet("tag25h9", 20, 9);
  // Files are long: not EXPECT_EQ, which would print them.
  const std::string pdf = sheet_pdf(sheet.plan, sheet.decor, "t");
  EXPECT_TRUE(pdf == sheet_pdf(sheet.plan, sheet.decor, "t"));
  EXPECT_EQ(pdf.find("CreationDate"), std::string::npos);
  EXPECT_TRUE(sheet_svg(sheet.plan, 0, sheet.decor) == sheet_svg(sheet.plan, 0, sheet.decor));
}

TEST(SheetWriter, TextsThatAreNotUtf8AreRefused) {
  SampleSheet sheet = sample_sheet("tag25h9", 20, 1);
  sheet.decor.title = "\xff\xfe";
  EXPECT_THROW(sheet_pdf(sheet.plan, sheet.decor, "t"), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::draw
