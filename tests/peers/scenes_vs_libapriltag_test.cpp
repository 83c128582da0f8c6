// Rendered scenes as libapriltag and our detector see them: the same tags in both.
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

// libapriltag's own headers mark only some of its functions as C.
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
}

#include "scene/random_scene.h"
#include "scene/render.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/detect/detector.h"

namespace tagmint::scene {
namespace {

struct PeerFamily {
  std::string name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

struct PeerTag {
  codec::TagId id;
  std::array<detect::Point, 4> corners;
};

std::vector<PeerTag> found_by_libapriltag(const PeerFamily& family, detect::Image image) {
  apriltag_family_t* tags = family.create();
  apriltag_detector_t* detector = apriltag_detector_create();
  apriltag_detector_add_family_bits(detector, tags, 2);
  detector->quad_decimate = 1;
  image_u8_t view = {.width = image.width(),
                     .height = image.height(),
                     .stride = image.width(),
                     .buf = image.row(0)};
  zarray_t* found = apriltag_detector_detect(detector, &view);
  std::vector<PeerTag> result;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* one = nullptr;
    zarray_get(found, i, &one);
    PeerTag& tag = result.emplace_back(PeerTag{static_cast<codec::TagId>(one->id), {}});
    for (std::size_t k = 0; k < 4; ++k) tag.corners[k] = {one->p[k][0], one->p[k][1]};
  }
  apriltag_detections_destroy(found);
  apriltag_detector_destroy(detector);
  family.destroy(tags);
  return result;
}

class ScenesBesideLibapriltag : public testing::TestWithParam<PeerFamily> {};

TEST_P(ScenesBesideLibapriltag, HoldTheSameTagsInTheSamePlaces) {
  const codec::SharedFamily family = codec::find_family(GetParam().name);
  detect::Detector detector({std::make_shared<const codec::Decoder>(family)});
  const std::vector<TagChoice> choices = {{family, {}}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RandomSceneOptions options;
    options.min_side_px = 50;
    options.effects = {.black = 30,
                       .white = 220,
                       .shading = {.strength = 0.2, .angle_deg = 30},
                       .blur_sigma_px = 0.7,
                       .noise_sigma = 2};
    options.seed = seed;
    const Scene scene = random_scene(choices, options);
    const detect::Image image = render(scene).image;
    std::set<codec::TagId> truth;
    for (const SceneTag& tag : scene.tags) truth.insert(tag.id);
    const std::vector<detect::Detection> ours = detector.detect(image);
    const std::vector<PeerTag> theirs = found_by_libapriltag(GetParam(), image);
    std::set<codec::TagId> our_ids;
    std::set<codec::TagId> their_ids;
    for (const PeerTag& tag : theirs) their_ids.insert(tag.id);
    for (const detect::Detection& detection : ours) {
      our_ids.insert(detection.id);
      for (const PeerTag& tag : theirs) {
        if (tag.id != detection.id) continue;
        for (std::size_t k = 0; k < 4; ++k) {
          EXPECT_LT(length(tag.corners[k] - detection.corners[k]), 0.5)
              << tag.id << " seed " << seed;
        }
      }
    }
    EXPECT_EQ(our_ids, truth) << "seed " << seed;
    EXPECT_EQ(their_ids, truth) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryBorder, ScenesBesideLibapriltag,
                         testing::Values(PeerFamily{"tag36h11", tag36h11_create, tag36h11_destroy},
                                         PeerFamily{"tagStandard41h12", tagStandard41h12_create,
                                                    tagStandard41h12_destroy},
                                         PeerFamily{"tagCustom48h12", tagCustom48h12_create,
                                                    tagCustom48h12_destroy}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace tagmint::scene
