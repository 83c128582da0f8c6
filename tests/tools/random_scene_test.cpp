#include "scene/random_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "scene/render.h"
#include "support/test_families.h"

namespace tagmint::scene {
namespace {

std::vector<TagChoice> one_family() { return {{test::arbitrary_family("classic:10", 30), {}}}; }

TEST(RandomScene, TagsAreWholeAndApart) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RandomSceneOptions options;
    options.seed = seed;
    const Scene scene = random_scene(one_family(), options);
    ASSERT_EQ(scene.tags.size(), 8U) << seed;
    for (const TagTruth& truth : render(scene).truth) EXPECT_NEAR(truth.visible, 1, 1e-6) << seed;
  }
}

TEST(RandomScene, KeepsToSizesAndTilts) {
  RandomSceneOptions options;
  options.width = 1280;
  options.height = 960;
  options.count = 60;
  options.min_side_px = 20;
  options.max_side_px = 60;
  options.min_tilt_deg = 15;
  options.max_tilt_deg = 40;
  const Scene scene = random_scene(one_family(), options);
  ASSERT_EQ(scene.tags.size(), 60U);
  double largest = 0;
  for (const SceneTag& tag : scene.tags) {
    const auto& posed = std::get<PosedTag>(tag.place);
    const auto& R = posed.pose.R;
    const auto& t = posed.pose.t;
    const double distance = std::hypot(t[0], t[1], t[2]);
    const double side = scene.camera.fx * posed.edge_m / distance;
    EXPECT_GE(side, 20 - 1e-9);
    EXPECT_LE(side, 60 + 1e-9);
    const double cosine = (R[2] * t[0] + R[5] * t[1] + R[8] * t[2]) / distance;
    const double tilt = std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
    EXPECT_GE(tilt, 15 - 1e-6);
    EXPECT_LE(tilt, 40 + 1e-6);
    largest = std::max(largest, tilt);
  }
  EXPECT_GT(largest, 35);
}

TEST(RandomScene, DealsEveryIdBeforeOneComesAgain) {
  RandomSceneOptions options;
  options.count = 12;
  options.min_side_px = options.max_side_px = 30;
  const codec::SharedFamily family = test::arbitrary_family("classic:10", 30);
  const std::vector<TagChoice> choices = {{family, {3, 5, 7, 9, 11, 13}}};
  std::multiset<codec::TagId> ids;
  for (const SceneTag& tag : random_scene(choices, options).tags) ids.insert(tag.id);
  EXPECT_EQ(ids, (std::multiset<codec::TagId>{3, 3, 5, 5, 7, 7, 9, 9, 11, 11, 13, 13}));
}

TEST(RandomScene, IsTheSameForTheSameSeedAlone) {
  RandomSceneOptions options;
  const detect::Image first = render(random_scene(one_family(), options)).image;
  EXPECT_EQ(first, render(random_scene(one_family(), options)).image);
  options.seed = 2;
  EXPECT_NE(first, render(random_scene(one_family(), options)).image);
}

TEST(RandomScene, IsSeenThroughTheCameraGiven) {
  RandomSceneOptions options;
  options.camera = default_camera(options.width, options.height);
  options.camera->k1 = -0.2;
  const Scene scene = random_scene(one_family(), options);
  EXPECT_EQ(scene.camera.k1, -0.2);
  for (const TagTruth& truth : render(scene).truth) EXPECT_NEAR(truth.visible, 1, 1e-6);
}

TEST(RandomScene, HasFewerTagsWhereThereIsNoRoom) {
  RandomSceneOptions options;
  options.count = 40;
  options.min_side_px = options.max_side_px = 150;
  const Scene scene = random_scene(one_family(), options);
  EXPECT_GT(scene.tags.size(), 0U);
  EXPECT_LT(scene.tags.size(), 40U);
}

TEST(RandomScene, RefusesImpossibleOptions) {
  const auto refused = [](auto change) {
    RandomSceneOptions options;
    change(options);
    EXPECT_THROW(random_scene(one_family(), options), std::invalid_argument);
  };
  refused([](auto& o) { o.count = -1; });
  refused([](auto& o) { o.min_side_px = 0; });
  refused([](auto& o) { o.max_side_px = 10; });
  refused([](auto& o) { o.max_tilt_deg = 86; });
  refused([](auto& o) { o.min_tilt_deg = 60; });
  refused([](auto& o) { o.min_tilt_deg = -1; });
  refused([](auto& o) { o.edge_m = 0; });
  refused([](auto& o) { o.width = 0; });
  EXPECT_THROW(random_scene({}, RandomSceneOptions{}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::scene
