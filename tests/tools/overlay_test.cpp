#include "draw/overlay.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>

#include "draw/debug_writer.h"
#include "scene/random_scene.h"
#include "scene/render.h"
#include "support/scratch_folder.h"
#include "support/test_families.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/detect/detector.h"

namespace tagmint::draw {
namespace {

bool is_green(const std::uint8_t* rgb) { return rgb[1] > 180 && rgb[0] < 120 && rgb[2] < 120; }
bool is_red(const std::uint8_t* rgb) { return rgb[0] > 180 && rgb[1] < 120 && rgb[2] < 120; }

io::FoundTag tag_at(const detect::Corners& corners) {
  io::FoundTag tag;
  tag.detection.family = test::arbitrary_family("classic:10");
  tag.detection.id = 7;
  tag.detection.corners = corners;
  tag.detection.center = {100, 100};
  return tag;
}

TEST(Overlay, MarksTheOutlineTheFirstCornerAndTheId) {
  const detect::Image gray(200, 200, 128);
  const std::vector<io::FoundTag> tags = {tag_at({{{40, 160}, {160, 160}, {160, 40}, {40, 40}}})};
  const io::RgbImage picture = draw_overlay(gray, tags);
  ASSERT_EQ(picture.width, 200);
  ASSERT_EQ(picture.height, 200);
  EXPECT_TRUE(is_green(picture.pixel(100, 40)));
  EXPECT_TRUE(is_green(picture.pixel(100, 160)));
  EXPECT_TRUE(is_green(picture.pixel(40, 100)));
  EXPECT_TRUE(is_red(picture.pixel(40, 160)));
  EXPECT_FALSE(is_red(picture.pixel(160, 40)));
  int letters = 0;
  for (int y = 85; y < 115; ++y) {
    for (int x = 85; x < 115; ++x) letters += picture.pixel(x, y)[0] > 240;
  }
  EXPECT_GT(letters, 20);
  const std::uint8_t* untouched = picture.pixel(20, 20);
  EXPECT_EQ(untouched[0], 128);
  EXPECT_EQ(untouched[1], 128);
  EXPECT_EQ(untouched[2], 128);
}

TEST(Overlay, DrawsTheXAxisInRedAndTheYAxisInGreen) {
  const detect::Image gray(200, 200, 128);
  std::vector<io::FoundTag> tags = {tag_at({{{40, 160}, {160, 160}, {160, 40}, {40, 40}}})};
  tags[0].pose.emplace();
  tags[0].pose->best.t = {0, 0, 1};
  const AxesSetting axes{.camera = {.fx = 120, .fy = 120, .cx = 100, .cy = 100}, .edge_m = 1};
  const io::RgbImage picture = draw_overlay(gray, tags, axes);
  EXPECT_TRUE(is_red(picture.pixel(140, 100)));
  EXPECT_TRUE(is_green(picture.pixel(100, 140)));
}

TEST(Overlay, OfTagsBeyondTheImageIsDrawnAllTheSame) {
  const detect::Image gray(20, 10, 128);
  const std::vector<io::FoundTag> tags = {
      tag_at({{{-400, 1600}, {1600, 1600}, {1600, -400}, {-400, -400}}})};
  EXPECT_EQ(draw_overlay(gray, tags).width, 20);
}

/// The pictures of a scene of three tags; the names of the files and the width of each.
void expect_debug_pictures(detect::Algorithm algorithm, const std::map<std::string, int>& widths) {
  const test::ScratchFolder folder;
  scene::RandomSceneOptions options;
  options.width = 320;
  options.height = 240;
  options.count = 3;
  options.max_side_px = 60;
  const std::vector<scene::TagChoice> choices = {{codec::find_family("tag36h11"), {}}};
  const detect::Image image = scene::render(scene::random_scene(choices, options)).image;
  DebugWriter writer(folder.path() / "steps", image.view());
  detect::DetectorOptions detector_options;
  detector_options.algorithm = algorithm;
  detect::Detector detector(
      {std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"))}, detector_options);
  EXPECT_EQ(detector.detect(image, nullptr, &writer).size(), 3U);
  std::map<std::string, int> written;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "steps")) {
    written[entry.path().filename()] = io::read_gray_image(entry.path().string()).width();
  }
  EXPECT_EQ(written, widths);
  EXPECT_EQ(io::read_gray_image((folder.path() / "steps" / "1-preprocessed.png").string()), image);
}

TEST(DebugWriter, WritesAPictureForEveryStepOfThePapersPath) {
  expect_debug_pictures(detect::Algorithm::Paper, {{"1-preprocessed.png", 320},
                                                   {"2-threshold.png", 320},
                                                   {"3-components.png", 320},
                                                   {"4-clusters.png", 640},
                                                   {"5-quads.png", 320},
                                                   {"6-refined-quads.png", 320},
                                                   {"7-detections.png", 320}});
}

TEST(DebugWriter, WritesWhatTheTrackerHasWhichIsNoComponents) {
  expect_debug_pictures(detect::Algorithm::Tracker, {{"1-preprocessed.png", 320},
                                                     {"2-threshold.png", 320},
                                                     {"4-clusters.png", 640},
                                                     {"5-quads.png", 320},
                                                     {"6-refined-quads.png", 320},
                                                     {"7-detections.png", 320}});
}

TEST(DebugWriter, WithoutAFolderToWriteToIsAnOutputError) {
  const test::ScratchFolder folder;
  test::write_file(folder.file("taken"), "a file");
  const detect::Image image(8, 8);
  EXPECT_THROW(DebugWriter(folder.file("taken"), image.view()), codec::OutputError);
}

}  // namespace
}  // namespace tagmint::draw
