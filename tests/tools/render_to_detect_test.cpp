// The chain inside the program: a scene is drawn, its tags are found again where they are.

#include <gtest/gtest.h>

#include <memory>

#include "scene/random_scene.h"
#include "scene/render.h"
#include "support/scene_accuracy.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/pose.h"

namespace tagmint::scene {
namespace {

std::vector<std::shared_ptr<const codec::Decoder>> decoders(
    const std::vector<std::string>& families) {
  std::vector<std::shared_ptr<const codec::Decoder>> made;
  for (const std::string& name : families) {
    // With two corrected bits, 1.7 % of all words are tags of 21h7, and noise gives about 200 quads
    // a picture: those would count as wrong ones here.
    codec::DecoderOptions options;
    if (name == "tagCircle21h7") options.max_errors = 0;
    made.push_back(std::make_shared<const codec::Decoder>(codec::find_family(name), options));
  }
  return made;
}

Scene hard_scene(const std::vector<std::string>& families, std::uint64_t seed) {
  std::vector<TagChoice> choices;
  for (const std::string& name : families) choices.push_back({codec::find_family(name), {}});
  RandomSceneOptions options;
  options.count = 6;
  options.min_side_px = 60;
  options.max_side_px = 110;
  options.max_tilt_deg = 60;
  options.effects = {.black = 30,
                     .white = 220,
                     .shading = {.strength = 0.3, .angle_deg = 20},
                     .blur_sigma_px = 1,
                     .noise_sigma = 5};
  options.seed = seed;
  return random_scene(choices, options);
}

class RenderToDetect : public testing::TestWithParam<std::string> {};

TEST_P(RenderToDetect, FindsEveryTagWithinATenthOfAPixel) {
  detect::Detector detector(decoders({GetParam()}));
  test::Accuracy accuracy;
  int tags = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Scene scene = hard_scene({GetParam()}, seed);
    const Rendering rendering = render(scene);
    tags += static_cast<int>(scene.tags.size());
    test::add_accuracy(scene, rendering.truth, detector.detect(rendering.image), accuracy);
  }
  EXPECT_EQ(accuracy.found, tags);
  EXPECT_EQ(accuracy.wrong, 0);
  EXPECT_LT(accuracy.median_px(), 0.1);
  RecordProperty("median_corner_error_px", std::to_string(accuracy.median_px()));
}

INSTANTIATE_TEST_SUITE_P(EveryLayoutKind, RenderToDetect,
                         testing::Values("tag36h11", "tagStandard41h12", "tagCircle21h7",
                                         "tagCustom48h12"),
                         [](const auto& each) { return each.param; });

TEST(RenderToDetect, FindsSeveralFamiliesInOnePicture) {
  const std::vector<std::string> families = {"tag36h11", "tagStandard41h12", "tagCircle21h7"};
  const Scene scene = hard_scene(families, 9);
  const Rendering rendering = render(scene);
  test::Accuracy accuracy;
  test::add_accuracy(scene, rendering.truth,
                     detect::Detector(decoders(families)).detect(rendering.image), accuracy);
  EXPECT_EQ(accuracy.found, 6);
  EXPECT_EQ(accuracy.wrong, 0);
}

TEST(RenderToDetect, RecoversThePoseThatWasDrawn) {
  const Scene scene = hard_scene({"tag36h11"}, 3);
  const Rendering rendering = render(scene);
  const auto found = detect::Detector(decoders({"tag36h11"})).detect(rendering.image);
  ASSERT_EQ(found.size(), scene.tags.size());
  for (const detect::Detection& detection : found) {
    for (const SceneTag& tag : scene.tags) {
      if (tag.id != detection.id) continue;
      const auto& truth = std::get<PosedTag>(tag.place);
      const auto pose = detect::estimate_pose(detection.corners, scene.camera, truth.edge_m);
      ASSERT_TRUE(pose);
      // A side of 60 px known to 0.1 px gives the distance to some thousandths.
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(pose->best.t[i], truth.pose.t[i], 0.01 * truth.pose.t[2]) << tag.id;
      }
    }
  }
}

}  // namespace
}  // namespace tagmint::scene
