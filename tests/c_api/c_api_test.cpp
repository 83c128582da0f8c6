// The C interface: the header stands alone (here as C++, in header_alone.c as C), no exception
// leaves it, wrong usage is told.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "support/tag_pictures.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/tag_cells.h"
#include "tagmint/codec/version.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/pose.h"
#include "tagmint/tagmint.h"

namespace tagmint::test {
namespace {

std::string last_error() { return tagmint_last_error(); }

struct FamilyFree {
  void operator()(tagmint_family* f) const { tagmint_family_free(f); }
};
struct DecoderFree {
  void operator()(tagmint_decoder* d) const { tagmint_decoder_free(d); }
};
struct DetectorFree {
  void operator()(tagmint_detector* d) const { tagmint_detector_free(d); }
};
struct DetectionsFree {
  void operator()(tagmint_detections* d) const { tagmint_detections_free(d); }
};
using FamilyHandle = std::unique_ptr<tagmint_family, FamilyFree>;
using DecoderHandle = std::unique_ptr<tagmint_decoder, DecoderFree>;
using DetectorHandle = std::unique_ptr<tagmint_detector, DetectorFree>;
using DetectionsHandle = std::unique_ptr<tagmint_detections, DetectionsFree>;

FamilyHandle family_named(const char* name) {
  tagmint_family* family = nullptr;
  EXPECT_EQ(tagmint_family_find(name, &family), TAGMINT_OK) << last_error();
  return FamilyHandle(family);
}

DecoderHandle decoder_of(const tagmint_family* family) {
  tagmint_decoder* decoder = nullptr;
  EXPECT_EQ(tagmint_decoder_create(family, TAGMINT_DEFAULT_ERRORS, nullptr, 0, &decoder),
            TAGMINT_OK)
      << last_error();
  return DecoderHandle(decoder);
}

DetectorHandle detector_of(const tagmint_decoder* decoder) {
  tagmint_detector* detector = nullptr;
  EXPECT_EQ(tagmint_detector_create(&decoder, 1, nullptr, &detector), TAGMINT_OK) << last_error();
  return DetectorHandle(detector);
}

tagmint_image image_of(const detect::Image& picture) {
  return {picture.row(0), picture.width(), picture.height(), picture.width()};
}

TEST(CApi, TellsItsVersion) {
  EXPECT_EQ(tagmint_c_version(), TAGMINT_C_VERSION);
  EXPECT_EQ(tagmint_version(), std::string(codec::kVersion));
}

TEST(CApi, ListsTheBundledFamilies) {
  const auto names = codec::family_names();
  ASSERT_EQ(tagmint_bundled_count(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(tagmint_bundled_name(i), names[i]);
  EXPECT_EQ(tagmint_bundled_name(names.size()), nullptr);
}

TEST(CApi, SaysWhatAFamilyIs) {
  const FamilyHandle family = family_named("tagStandard41h12");
  tagmint_family_info info;
  ASSERT_EQ(tagmint_family_get_info(family.get(), &info), TAGMINT_OK);
  EXPECT_STREQ(info.name, "tagStandard41h12");
  EXPECT_EQ(info.codes, 2115u);
  EXPECT_EQ(info.bits, 41);
  EXPECT_EQ(info.min_hamming, 12);
  EXPECT_EQ(info.safe_errors, 5);
  EXPECT_EQ(info.width, 9);
  EXPECT_EQ(info.width_at_border, 5);
  EXPECT_EQ(info.reversed_border, 1);
}

TEST(CApi, GivesCodewordsAndCells) {
  const FamilyHandle handle = family_named("tagCustom48h12");
  const codec::SharedFamily family = codec::find_family("tagCustom48h12");
  std::uint64_t codeword = 0;
  ASSERT_EQ(tagmint_family_codeword(handle.get(), 7, &codeword), TAGMINT_OK);
  EXPECT_EQ(codeword, family->codeword(7));
  std::vector<char> cells(101, '?');
  ASSERT_EQ(tagmint_family_cells(handle.get(), 7, 100, cells.data()), TAGMINT_OK);
  std::string expected;
  for (const std::string& row : codec::tag_cells(family->layout(), codeword).rows()) {
    expected += row;
  }
  EXPECT_EQ(std::string(cells.data(), 100), expected);
  EXPECT_EQ(cells[100], '?');
  EXPECT_EQ(tagmint_family_cells(handle.get(), 7, 99, cells.data()), TAGMINT_ERROR_ARGUMENT);
  EXPECT_EQ(last_error(), "there is room for 99 cells, but tagCustom48h12 has 100; give more");
  EXPECT_EQ(tagmint_family_codeword(handle.get(), 42211, &codeword), TAGMINT_ERROR_ARGUMENT);
  EXPECT_EQ(last_error(), "tagCustom48h12 has no id 42211; ids are 0 to 42210");
}

TEST(CApi, ReadsFamiliesFromTextsAndTellsTheFault) {
  const std::string text = codec::format_family(*codec::find_family("tag16h5"));
  tagmint_family* family = nullptr;
  ASSERT_EQ(tagmint_family_parse(text.data(), text.size(), "my.json", &family), TAGMINT_OK);
  tagmint_family_info info;
  ASSERT_EQ(tagmint_family_get_info(family, &info), TAGMINT_OK);
  EXPECT_EQ(info.codes, 30u);
  tagmint_family_free(family);

  tagmint_family* untouched = reinterpret_cast<tagmint_family*>(&info);
  family = untouched;
  EXPECT_EQ(tagmint_family_parse(text.data(), 40, "my.json", &family), TAGMINT_ERROR_INPUT);
  EXPECT_NE(last_error().find("my.json"), std::string::npos) << last_error();
  EXPECT_EQ(tagmint_family_load("no/such.json", &family), TAGMINT_ERROR_INPUT);
  EXPECT_EQ(tagmint_family_find("tag36h12", &family), TAGMINT_ERROR_INPUT);
  EXPECT_NE(last_error().find("tag36h11"), std::string::npos) << last_error();
  EXPECT_EQ(family, untouched);  // written on success only
}

TEST(CApi, DecodesAsTheDecoderDoes) {
  const FamilyHandle family = family_named("tag36h11");
  const DecoderHandle decoder = decoder_of(family.get());
  std::uint64_t word = 0;
  ASSERT_EQ(tagmint_family_codeword(family.get(), 100, &word), TAGMINT_OK);
  word = codec::rotate(word, 36, 1) ^ 0b11;
  tagmint_match match;
  ASSERT_EQ(tagmint_decoder_decode(decoder.get(), word, &match), TAGMINT_OK);
  EXPECT_EQ(match.id, 100u);
  EXPECT_EQ(match.hamming, 2);
  EXPECT_EQ(match.rotation, 3);
  EXPECT_EQ(tagmint_decoder_decode(decoder.get(), 0, &match), TAGMINT_NOTHING);
  EXPECT_EQ(tagmint_decoder_decode(decoder.get(), std::uint64_t{1} << 36, &match),
            TAGMINT_ERROR_ARGUMENT);
}

TEST(CApi, AFewIdsMayBeReadWithMoreErrors) {
  const FamilyHandle family = family_named("tag36h11");
  const std::uint32_t ids[] = {5, 40};
  tagmint_decoder* decoder = nullptr;
  ASSERT_EQ(tagmint_decoder_create(family.get(), 7, ids, 2, &decoder), TAGMINT_OK) << last_error();
  tagmint_decoder_free(decoder);
  EXPECT_EQ(tagmint_decoder_create(family.get(), 7, nullptr, 0, &decoder), TAGMINT_ERROR_ARGUMENT);
  EXPECT_EQ(tagmint_decoder_create(family.get(), -2, nullptr, 0, &decoder), TAGMINT_ERROR_ARGUMENT);
  const std::uint32_t missing = 587;
  EXPECT_EQ(tagmint_decoder_create(family.get(), 0, &missing, 1, &decoder), TAGMINT_ERROR_ARGUMENT);
  EXPECT_EQ(tagmint_decoder_create(family.get(), 0, nullptr, 3, &decoder), TAGMINT_ERROR_ARGUMENT);
  EXPECT_EQ(tagmint_decoder_create(family.get(), 0, ids, 0, &decoder), TAGMINT_ERROR_ARGUMENT);
}

TEST(CApi, DetectsAsTheDetectorDoesThroughAnyStride) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  const detect::Image picture = print_tag(*family, 3, {.cell_px = 9, .quiet_cells = 2});
  detect::Detector reference({std::make_shared<const codec::Decoder>(family)});
  const detect::Detection expected = reference.detect(picture).at(0);

  DecoderHandle decoder;
  {
    const FamilyHandle handle = family_named("tag36h11");
    decoder = decoder_of(handle.get());
  }  // the decoder keeps its family, the detector its decoder
  const DetectorHandle detector = detector_of(decoder.get());
  decoder.reset();
  // The same picture with its rows in reverse order in memory.
  std::vector<std::uint8_t> upside_down;
  for (int y = picture.height() - 1; y >= 0; --y) {
    upside_down.insert(upside_down.end(), picture.row(y), picture.row(y) + picture.width());
  }
  const std::uint8_t* top = upside_down.data() + (picture.height() - 1) * picture.width();
  for (const tagmint_image& image :
       {image_of(picture),
        tagmint_image{top, picture.width(), picture.height(), -picture.width()}}) {
    tagmint_detections* found = nullptr;
    ASSERT_EQ(tagmint_detector_detect(detector.get(), &image, &found), TAGMINT_OK) << last_error();
    const DetectionsHandle owner(found);
    ASSERT_EQ(tagmint_detections_count(found), 1u);
    const tagmint_detection& tag = tagmint_detections_data(found)[0];
    EXPECT_STREQ(tag.family, "tag36h11");
    EXPECT_EQ(tag.id, 3u);
    EXPECT_EQ(tag.hamming, 0);
    EXPECT_EQ(tag.decision_margin, expected.decision_margin);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(tag.corners[i][0], expected.corners[i].x);
      EXPECT_EQ(tag.corners[i][1], expected.corners[i].y);
    }
    EXPECT_EQ(tag.center[0], expected.center.x);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_EQ(tag.homography[i], expected.homography.row_major()[i]);
    }
  }
}

TEST(CApi, DetectionsOutliveTheirDetector) {
  const detect::Image picture =
      print_tag(*codec::find_family("tag25h9"), 3, {.cell_px = 9, .quiet_cells = 2});
  const tagmint_image image = image_of(picture);
  tagmint_detections* found = nullptr;
  {
    const FamilyHandle family = family_named("tag25h9");
    const DecoderHandle decoder = decoder_of(family.get());
    const DetectorHandle detector = detector_of(decoder.get());
    ASSERT_EQ(tagmint_detector_detect(detector.get(), &image, &found), TAGMINT_OK);
  }
  const DetectionsHandle owner(found);
  ASSERT_EQ(tagmint_detections_count(found), 1u);
  EXPECT_STREQ(tagmint_detections_data(found)->family, "tag25h9");
}

TEST(CApi, OptionsAreCheckedAndNamed) {
  const FamilyHandle family = family_named("tag16h5");
  const DecoderHandle decoder = decoder_of(family.get());
  const tagmint_decoder* decoders[] = {decoder.get(), nullptr};
  tagmint_detector_options options;
  tagmint_detector_options_init(&options);
  const detect::DetectorOptions defaults;
  EXPECT_EQ(options.decimate, defaults.decimate);
  EXPECT_EQ(options.refine_edges, defaults.refine_edges);
  tagmint_detector* detector = nullptr;
  options.decimate = 0.5;
  EXPECT_EQ(tagmint_detector_create(decoders, 1, &options, &detector), TAGMINT_ERROR_ARGUMENT);
  EXPECT_NE(last_error().find("decimate"), std::string::npos) << last_error();
  options = {};
  EXPECT_EQ(tagmint_detector_create(decoders, 1, &options, &detector), TAGMINT_ERROR_ARGUMENT);
  EXPECT_NE(last_error().find("tagmint_detector_options_init"), std::string::npos);
  EXPECT_EQ(tagmint_detector_create(decoders, 0, nullptr, &detector), TAGMINT_ERROR_ARGUMENT);
  EXPECT_EQ(tagmint_detector_create(decoders, 2, nullptr, &detector), TAGMINT_ERROR_ARGUMENT);
  tagmint_detector_options_init(nullptr);
}

TEST(CApi, PicturesAreChecked) {
  const FamilyHandle family = family_named("tag16h5");
  const DecoderHandle decoder = decoder_of(family.get());
  const DetectorHandle detector = detector_of(decoder.get());
  const std::uint8_t pixels[64] = {};
  tagmint_detections* found = nullptr;
  for (const tagmint_image& wrong :
       {tagmint_image{nullptr, 8, 8, 8}, tagmint_image{pixels, -8, 8, 8},
        tagmint_image{pixels, 8, -8, 8}, tagmint_image{pixels, 8, 8, 7},
        tagmint_image{pixels, 8, 8, -7}}) {
    EXPECT_EQ(tagmint_detector_detect(detector.get(), &wrong, &found), TAGMINT_ERROR_ARGUMENT);
  }
  for (const tagmint_image& empty :
       {tagmint_image{nullptr, 0, 8, 0}, tagmint_image{pixels, 8, 8, 8}}) {
    ASSERT_EQ(tagmint_detector_detect(detector.get(), &empty, &found), TAGMINT_OK);
    EXPECT_EQ(tagmint_detections_count(found), 0u);
    EXPECT_EQ(tagmint_detections_data(found), nullptr);
    tagmint_detections_free(found);
  }
}

TEST(CApi, NullIsAnArgumentErrorEverywhere) {
  const FamilyHandle family = family_named("tag16h5");
  const DecoderHandle decoder = decoder_of(family.get());
  const DetectorHandle detector = detector_of(decoder.get());
  const tagmint_decoder* decoders[] = {decoder.get()};
  const std::uint8_t pixels[64] = {};
  const tagmint_image image = {pixels, 8, 8, 8};
  const double corners[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  const tagmint_camera camera = {1, 1, 0, 0, 0, 0, 0, 0, 0};
  tagmint_family* f = nullptr;
  tagmint_decoder* c = nullptr;
  tagmint_detector* d = nullptr;
  tagmint_detections* found = nullptr;
  tagmint_family_info info;
  tagmint_match match;
  tagmint_pose_estimate pose;
  std::uint64_t word = 0;
  char cells[64];
  const tagmint_status statuses[] = {
      tagmint_family_find(nullptr, &f),
      tagmint_family_find("tag16h5", nullptr),
      tagmint_family_load(nullptr, &f),
      tagmint_family_load("tag16h5", nullptr),
      tagmint_family_parse(nullptr, 0, "a", &f),
      tagmint_family_parse("", 0, nullptr, &f),
      tagmint_family_parse("", 0, "a", nullptr),
      tagmint_family_get_info(nullptr, &info),
      tagmint_family_get_info(family.get(), nullptr),
      tagmint_family_codeword(nullptr, 0, &word),
      tagmint_family_codeword(family.get(), 0, nullptr),
      tagmint_family_cells(nullptr, 0, 64, cells),
      tagmint_family_cells(family.get(), 0, 64, nullptr),
      tagmint_decoder_create(nullptr, 0, nullptr, 0, &c),
      tagmint_decoder_create(family.get(), 0, nullptr, 0, nullptr),
      tagmint_decoder_decode(nullptr, 0, &match),
      tagmint_decoder_decode(decoder.get(), 0, nullptr),
      tagmint_detector_create(nullptr, 1, nullptr, &d),
      tagmint_detector_create(decoders, 1, nullptr, nullptr),
      tagmint_detector_detect(nullptr, &image, &found),
      tagmint_detector_detect(detector.get(), nullptr, &found),
      tagmint_detector_detect(detector.get(), &image, nullptr),
      tagmint_estimate_pose(nullptr, &camera, 1, &pose),
      tagmint_estimate_pose(corners, nullptr, 1, &pose),
      tagmint_estimate_pose(corners, &camera, 1, nullptr),
  };
  int number = 0;
  for (const tagmint_status status : statuses)
    EXPECT_EQ(status, TAGMINT_ERROR_ARGUMENT) << number++;
  EXPECT_EQ(last_error(), "the argument 'pose' is null; give a pointer");
  EXPECT_EQ(tagmint_detections_count(nullptr), 0u);
  EXPECT_EQ(tagmint_detections_data(nullptr), nullptr);
  tagmint_family_free(nullptr);
  tagmint_decoder_free(nullptr);
  tagmint_detector_free(nullptr);
  tagmint_detections_free(nullptr);
}

TEST(CApi, EstimatesThePoseOfASquare) {
  // A square of 0.2 m, frontal, 1 m away, 0.1 m to the right.
  const tagmint_camera camera = {500, 500, 320, 240, 0, 0, 0, 0, 0};
  const double corners[4][2] = {{320, 290}, {420, 290}, {420, 190}, {320, 190}};
  tagmint_pose_estimate pose;
  ASSERT_EQ(tagmint_estimate_pose(corners, &camera, 0.2, &pose), TAGMINT_OK) << last_error();
  EXPECT_NEAR(pose.best.t[0], 0.1, 1e-6);
  EXPECT_NEAR(pose.best.t[1], 0, 1e-6);
  EXPECT_NEAR(pose.best.t[2], 1, 1e-6);
  EXPECT_NEAR(pose.best.R[0], 1, 1e-6);
  const double line[4][2] = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  EXPECT_EQ(tagmint_estimate_pose(line, &camera, 0.2, &pose), TAGMINT_NOTHING);
  EXPECT_EQ(tagmint_estimate_pose(corners, &camera, 0, &pose), TAGMINT_ERROR_ARGUMENT);
}

TEST(CApi, EachThreadHasItsOwnMessage) {
  tagmint_family* family = nullptr;
  ASSERT_EQ(tagmint_family_find("here", &family), TAGMINT_ERROR_INPUT);
  const std::string here = last_error();
  std::string before, there;
  std::thread([&] {
    before = last_error();
    tagmint_family_find("there", &family);
    there = last_error();
  }).join();
  EXPECT_EQ(before, "");
  EXPECT_NE(there.find("'there'"), std::string::npos);
  EXPECT_EQ(last_error(), here);
}

TEST(CApi, ALongMessageIsCutAndEnds) {
  const std::string name(100000, 'x');
  tagmint_family* family = nullptr;
  EXPECT_EQ(tagmint_family_find(name.c_str(), &family), TAGMINT_ERROR_INPUT);
  EXPECT_EQ(std::strlen(tagmint_last_error()), 1023u);
}

TEST(CApi, ADetectorInUseIsBusyAndTheOtherCallsResultsStand) {
  const FamilyHandle family = family_named("tag36h11");
  const DecoderHandle decoder = decoder_of(family.get());
  const DetectorHandle detector = detector_of(decoder.get());
  const detect::Image picture =
      print_tag(*codec::find_family("tag36h11"), 3, {.cell_px = 60, .quiet_cells = 2});
  const tagmint_image image = image_of(picture);
  std::atomic<int> found_tags = 0, busy = 0, other = 0;
  const auto look = [&] {
    for (int i = 0; i < 20; ++i) {
      tagmint_detections* found = nullptr;
      const tagmint_status status = tagmint_detector_detect(detector.get(), &image, &found);
      if (status == TAGMINT_OK) found_tags += static_cast<int>(tagmint_detections_count(found));
      busy += status == TAGMINT_ERROR_BUSY;
      other += status != TAGMINT_OK && status != TAGMINT_ERROR_BUSY;
      tagmint_detections_free(found);
    }
  };
  std::thread a(look), b(look);
  a.join();
  b.join();
  EXPECT_EQ(other, 0);
  EXPECT_EQ(found_tags + busy, 40);
  EXPECT_GE(found_tags, 20);
}

}  // namespace
}  // namespace tagmint::test
