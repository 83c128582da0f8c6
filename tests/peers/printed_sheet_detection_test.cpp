// Our detector reads our sheets as Poppler draws the PDF and librsvg the SVG: every tag, at its
// place.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>

#include "draw/sheet_writer.h"
#include "support/rasterise.h"
#include "support/sheet_samples.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector.h"

namespace tagmint::draw {
namespace {

constexpr double kDpi = 300;

/// Without corrected errors, so that the letters beside the tags of small families are no tags;
/// with corners from the border lines alone, since drawn edges have no blur.
detect::Detector detector_of(const std::string& family) {
  detect::DetectorOptions options;
  options.refine_photometric = false;
  return detect::Detector(
      {std::make_shared<const codec::Decoder>(
          codec::find_family(family), codec::DecoderOptions{.max_errors = 0,
                                                            .allow_unsafe_radius = false,
                                                            .engine = codec::DecoderEngine::Auto,
                                                            .ids = {}})},
      options);
}

/// Expects that each planned tag of the page, and nothing else, is found where the plan has it.
void expect_all_tags(const detect::Image& picture, const SheetPlan& plan, std::size_t page,
                     detect::Detector& detector) {
  std::map<codec::TagId, const PlacedTag*> missing;
  for (const PlacedTag& tag : plan.pages[page].tags) missing[tag.id] = &tag;
  for (const detect::Detection& found : detector.detect(picture)) {
    const auto tag = missing.find(found.id);
    ASSERT_NE(tag, missing.end()) << "id " << found.id << " is not there, or found twice";
    const detect::Corners planned = test::planned_corners(plan, *tag->second, kDpi);
    for (int k = 0; k < 4; ++k) {
      // Edges are between pixels; a renderer rounds them by up to half a pixel, which is 0.04 mm.
      EXPECT_LT(length(found.corners[k] - planned[k]), 0.75)
          << "id " << found.id << " corner " << k;
    }
    missing.erase(tag);
  }
  EXPECT_TRUE(missing.empty()) << missing.size() << " tags are not found, the first is id "
                               << missing.begin()->first;
}

class PrintedSheetDetection : public testing::TestWithParam<std::string> {};

TEST_P(PrintedSheetDetection, EveryTagOfThePdfAndTheSvgDecodes) {
  const std::size_t size = codec::find_family(GetParam())->size();
  const test::SampleSheet sheet =
      test::sample_sheet(GetParam(), 13, std::min<std::size_t>(size, 60));
  detect::Detector detector = detector_of(GetParam());
  const auto pages = test::pdf_pages(sheet_pdf(sheet.plan, sheet.decor, "test"), kDpi);
  ASSERT_EQ(pages.size(), sheet.plan.pages.size());
  for (std::size_t page = 0; page < pages.size(); ++page) {
    SCOPED_TRACE("page " + std::to_string(page + 1));
    expect_all_tags(pages[page], sheet.plan, page, detector);
    expect_all_tags(test::svg_picture(sheet_svg(sheet.plan, page, sheet.decor), kDpi), sheet.plan,
                    page, detector);
  }
}

INSTANTIATE_TEST_SUITE_P(BundledFamily, PrintedSheetDetection,
                         testing::ValuesIn(codec::family_names().begin(),
                                           codec::family_names().end()),
                         [](const auto& info) { return info.param; });

TEST(PrintedSheetDetectionOfAWholeFamily, EveryTagOfTag36h11Decodes) {
  const test::SampleSheet sheet = test::sample_sheet("tag36h11", 15, 587);
  detect::Detector detector = detector_of("tag36h11");
  const auto pages = test::pdf_pages(sheet_pdf(sheet.plan, sheet.decor, "test"), kDpi);
  ASSERT_EQ(pages.size(), sheet.plan.pages.size());
  for (std::size_t page = 0; page < pages.size(); ++page) {
    SCOPED_TRACE("page " + std::to_string(page + 1));
    expect_all_tags(pages[page], sheet.plan, page, detector);
  }
}

}  // namespace
}  // namespace tagmint::draw
