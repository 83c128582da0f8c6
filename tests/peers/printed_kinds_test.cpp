// Each kind of file as other programs draw it, at 300 and 1200 dpi: lengths, quiet zones, seams,
// and what two detectors read.
#include "support/printed_kinds.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "draw/cut_outline.h"
#include "draw/sheet_check.h"
#include "draw/units.h"
#include "support/rasterise.h"
#include "support/scratch_folder.h"
#include "support/sheet_measure.h"
#include "support/sheet_samples.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector.h"

namespace tagmint::draw {
namespace {

using test::measure_page;
using test::Printed;
using test::SheetMeasures;

// Whole CSS pixels: Chromium draws an SVG with its sides rounded to them, and stretches it by that.
constexpr double kWidthMm = 240 * kMmAnInch / 96;
constexpr double kHeightMm = 460 * kMmAnInch / 96;

/// A small page with three kinds of layout and all that may stand beside tags.
///   dpi   where cells are to be whole dots; 0 = sizes that are no whole dots of anything
test::SampleSheet small_sheet(double dpi = 0, CutShape cut_shape = CutShape::Square) {
  std::vector<TagGroup> groups = {{codec::find_family("tag36h11"), 13.7, {7, 11}},
                                  {codec::find_family("tagCircle49h12"), 6.3, {21, 22}},
                                  {codec::find_family("tagCustom48h12"), 9, {42210}}};
  for (TagGroup& group : groups) {
    if (dpi > 0) group.edge_mm = whole_dot_edge(group.family->layout(), group.edge_mm, dpi);
  }
  const SheetDecor decor{.label = TextFormat("{family} {id:05}", label_fields()),
                         .title = "Small & <fine>",
                         .notes = true,
                         .ruler = RulerPlace::Lying,
                         .cut_marks = true,
                         .cut_lines = true};
  const SheetOptions options{.page_width_mm = kWidthMm,
                             .page_height_mm = kHeightMm,
                             .margin_mm = 4,
                             .gap_mm = 4,
                             .label_mm = label_height_mm(decor, groups),
                             .header_mm = header_height_mm(decor),
                             .footer_mm = footer_height_mm(decor, groups.size()),
                             .cut_shape = cut_shape,
                             .dot_mm = dpi > 0 ? kMmAnInch / dpi : 0};
  return {plan_sheet(groups, options), decor};
}

class PrintedKind : public testing::TestWithParam<Printed> {};

TEST_P(PrintedKind, HasEveryEdgeInPlaceAndNothingInQuietZones) {
  for (const double dpi : {300.0, 1200.0}) {
    const test::SampleSheet sheet = small_sheet(GetParam().whole_dots ? dpi : 0);
    ASSERT_EQ(sheet.plan.pages.size(), 1u);
    const detect::Image picture = GetParam().picture(sheet.plan, sheet.decor, dpi);
    // Programs round the page to whole points or pixels of their own.
    EXPECT_NEAR(picture.width(), kWidthMm / kMmAnInch * dpi, dpi / 72) << dpi;
    EXPECT_NEAR(picture.height(), kHeightMm / kMmAnInch * dpi, dpi / 72) << dpi;
    const SheetMeasures m = measure_page(picture, dpi, sheet.plan, 0);
    EXPECT_EQ(m.tags, 5);
    EXPECT_EQ(m.wrong_cells, 0) << dpi;
    EXPECT_GT(m.edges, 300);
    EXPECT_LT(m.largest_error_mm, dpi < 1000 ? 0.1 : 0.05) << dpi;
    EXPECT_EQ(m.gray_in_black, 0) << dpi;
    EXPECT_EQ(m.ink_in_quiet, 0) << dpi;
    EXPECT_EQ(m.labels, 5) << dpi;
    EXPECT_EQ(m.ink_at_labels_rim, 0) << dpi;
    RecordProperty("largest_error_um_at_" + std::to_string(int(dpi)),
                   static_cast<int>(std::lround(1000 * m.largest_error_mm)));
    // Where pixels are large, programs move edges by parts of one.
    const PageCheck read =
        SheetChecker(sheet.plan.groups, false)
            .check({picture, dpi / kMmAnInch}, sheet.plan, 0, dpi < 1000 ? 0.03 : 0.0);
    EXPECT_FALSE(read.fault) << dpi << ": id " << read.fault->id << " " << read.fault->what;
    EXPECT_EQ(read.tags, 5u);
  }
}

TEST_P(PrintedKind, HasNoSeamsAtOddZooms) {
  const test::SampleSheet sheet = small_sheet();
  for (const double dpi : {97.0, 211.0}) {
    const detect::Image picture = GetParam().picture(sheet.plan, sheet.decor, dpi);
    EXPECT_EQ(measure_page(picture, dpi, sheet.plan, 0).gray_in_black, 0) << dpi;
  }
}

/// The ids that libapriltag reads, without corrected errors.
std::vector<int> ids_of_libapriltag(apriltag_family_t* family, detect::Image& picture) {
  apriltag_detector_t* const detector = apriltag_detector_create();
  apriltag_detector_add_family_bits(detector, family, 0);
  detector->quad_decimate = 1.0f;
  image_u8_t image = {picture.width(), picture.height(), picture.width(), picture.row(0)};
  zarray_t* const found = apriltag_detector_detect(detector, &image);
  std::vector<int> ids;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found, i, &detection);
    ids.push_back(detection->id);
  }
  apriltag_detections_destroy(found);
  apriltag_detector_destroy(detector);
  std::sort(ids.begin(), ids.end());
  return ids;
}

TEST_P(PrintedKind, IsReadByLibapriltag) {
  const test::SampleSheet sheet = small_sheet();
  detect::Image picture = GetParam().picture(sheet.plan, sheet.decor, 300);
  apriltag_family_t* family = tag36h11_create();
  EXPECT_EQ(ids_of_libapriltag(family, picture), (std::vector<int>{7, 11}));
  tag36h11_destroy(family);
  family = tagCircle49h12_create();
  EXPECT_EQ(ids_of_libapriltag(family, picture), (std::vector<int>{21, 22}));
  tagCircle49h12_destroy(family);
  family = tagCustom48h12_create();
  EXPECT_EQ(ids_of_libapriltag(family, picture), (std::vector<int>{42210}));
  tagCustom48h12_destroy(family);
}

INSTANTIATE_TEST_SUITE_P(All, PrintedKind, testing::ValuesIn(test::printed_kinds()),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           name.erase(std::remove_if(name.begin(), name.end(),
                                                     [](char c) { return c == ' ' || c == ','; }),
                                      name.end());
                           return name;
                         });

TEST(PrintedCircle, CutsOutsideOfTheQuietZone) {
  const test::SampleSheet sheet = small_sheet(0, CutShape::Circle);
  const double dpi = 600;
  const double scale = dpi / kMmAnInch;
  const detect::Image picture =
      test::pdf_pages(test::file_content(sheet.plan, sheet.decor, FileKind::Pdf), dpi).at(0);
  for (const PlacedTag& tag : sheet.plan.pages[0].tags) {
    const codec::Layout& layout = sheet.plan.groups[tag.group].family->layout();
    const double cell = tag.outer.width_mm / layout.width();
    const double x = tag.outer.x_mm + tag.outer.width_mm / 2;
    const double y = tag.outer.y_mm + tag.outer.width_mm / 2;
    const double inner = radius_cells(layout) * cell + 1.5 / scale;
    const double outer = radius_cells(layout) * cell + tag.quiet_mm - 0.5 / scale;
    int on_line = 0;
    for (int step = 0; step < 3600; ++step) {
      const double angle = step * M_PI / 1800;
      const auto gray = [&](double radius) {
        return picture.at(static_cast<int>((x + radius * std::cos(angle)) * scale),
                          static_cast<int>((y + radius * std::sin(angle)) * scale));
      };
      for (double radius = inner; radius < outer; radius += 0.5 / scale) {
        ASSERT_GT(gray(radius), 250) << tag.id << " at " << angle << ", " << radius;
      }
      if (gray(radius_cells(layout) * cell + tag.quiet_mm + kCutLineMm) < 200) ++on_line;
    }
    EXPECT_GT(on_line, 3000) << tag.id;
  }
}

#ifdef TAGMINT_CHROMIUM
TEST(PrintedByABrowser, AWholePageHasItsSizeAndLengths) {
  // A4 is no whole number of CSS pixels: the page is stretched by up to half of one a side.
  const test::SampleSheet sheet = test::sample_sheet("tag36h11", 40, 12);
  const double dpi = 300;
  const detect::Image picture =
      test::pdf_pages(test::chromium_pdf(test::file_content(sheet.plan, sheet.decor, FileKind::Svg),
                                         TAGMINT_CHROMIUM),
                      dpi)
          .at(0);
  EXPECT_NEAR(picture.width(), 2480.3, 2);
  EXPECT_NEAR(picture.height(), 3507.9, 2);
  const PageCheck read = SheetChecker(sheet.plan.groups, false)
                             .check({picture, dpi / kMmAnInch}, sheet.plan, 0, kMmAnInch / 96 / 2);
  EXPECT_FALSE(read.fault) << "id " << read.fault->id << " " << read.fault->what;
  detect::DetectorOptions options;
  options.refine_photometric = false;  // drawn edges have no blur
  detect::Detector detector(
      {std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"))}, options);
  const auto found = detector.detect(picture);
  EXPECT_EQ(found.size(), 12u);
  for (const detect::Detection& tag : found) {
    for (int k = 0; k < 4; ++k) {
      const double side = length(tag.corners[(k + 1) % 4] - tag.corners[k]) / dpi * kMmAnInch;
      EXPECT_NEAR(side, 40, 0.05) << tag.id;
    }
  }
}
#endif

TEST(PrintedInk, InvertedTagsHaveInkWhereTheyAreWhite) {
  test::SampleSheet sheet = small_sheet();
  sheet.decor.inverted = true;
  const double dpi = 300;
  const detect::Image picture =
      test::pdf_pages(test::file_content(sheet.plan, sheet.decor, FileKind::Pdf), dpi).at(0);
  EXPECT_FALSE(
      SheetChecker(sheet.plan.groups, true).check({picture, dpi / kMmAnInch}, sheet.plan, 0).fault);
}

TEST(PrintedInk, BlackIsPureInTheFile) {
  const test::ScratchFolder folder;
  const test::SampleSheet sheet = small_sheet();
  FileOptions options;
  const auto operators = [&] {
    const std::string path =
        folder.write("a.pdf", test::file_content(sheet.plan, sheet.decor, FileKind::Pdf, options));
    return test::output_of("qpdf --qdf --object-streams=disable '" + path + "' -");
  };
  const std::string gray = operators();
  EXPECT_NE(gray.find("\n0 g\n"), std::string::npos);
  EXPECT_EQ(gray.find(" rg\n"), std::string::npos);
  EXPECT_EQ(gray.find(" k\n"), std::string::npos);
  options.ink_model = InkModel::Key;
  const std::string key = operators();
  EXPECT_NE(key.find("0 0 0 1 k\n"), std::string::npos);
  EXPECT_EQ(key.find(" g\n"), std::string::npos);
  EXPECT_EQ(key.find(" rg\n"), std::string::npos);
}

TEST(PrintedRuler, MeasuresWhatItSays) {
  // A whole page: the ruler of 150 mm.
  const test::SampleSheet sheet = test::sample_sheet("tag36h11", 40, 3);
  const double dpi = 600;
  const double scale = dpi / kMmAnInch;
  const detect::Image picture =
      test::pdf_pages(test::file_content(sheet.plan, sheet.decor, FileKind::Pdf), dpi).at(0);
  // The row of pixels 3.1 mm below the ruler's line crosses its centimetre ticks alone.
  const Box area = sheet.plan.area();
  const double line = area.bottom_mm() - kNoteLineMm - kRulerDepthMm;
  const int row = static_cast<int>((line + 3.1) * scale);
  std::vector<double> ticks;
  double weight = 0, moment = 0;
  for (int x = 0; x < (area.x_mm + 156) * scale; ++x) {
    const double ink = (255 - picture.at(x, row)) / 255.0;
    weight += ink;
    moment += ink * (x + 0.5);
    if (ink == 0 && weight > 0) {
      ticks.push_back(moment / weight / scale);
      weight = moment = 0;
    }
  }
  ASSERT_EQ(ticks.size(), 16u);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_NEAR(ticks[i] - ticks[0], 10.0 * double(i), 0.02);
  }
}

}  // namespace
}  // namespace tagmint::draw
