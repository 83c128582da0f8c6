#include "detector/scattered_sets.h"

#include "detector/drawn_scene.h"
#include "scene/counter_random.h"

namespace tagmint::bench {

using scene::RandomSceneOptions;

RandomSceneOptions scattered(const PictureSize& size, int count, double min_side_px,
                             double max_side_px) {
  RandomSceneOptions options;
  options.width = size.width;
  options.height = size.height;
  options.count = count;
  options.min_side_px = min_side_px;
  options.max_side_px = max_side_px;
  options.max_tilt_deg = 50;
  options.background = scene::ClutterBackground{};
  options.effects = camera_effects(5);
  return options;
}

PictureSet random_set(std::string name, std::string about, const RandomSceneOptions& options,
                      Task task) {
  PictureSet set{.name = std::move(name), .about = std::move(about), .task = std::move(task)};
  set.draw = [options, families = set.task.families](int index, std::uint64_t seed) {
    RandomSceneOptions own = options;
    own.seed = picture_seed(seed, index);
    return picture_of(scene::random_scene(choices_of(families), own));
  };
  return set;
}

PictureSet changed_set(std::string name, std::string about, const RandomSceneOptions& options,
                       SceneChange change) {
  PictureSet set{.name = std::move(name), .about = std::move(about)};
  set.draw = [options, change, families = set.task.families](int index, std::uint64_t seed) {
    RandomSceneOptions own = options;
    own.seed = picture_seed(seed, index);
    scene::Scene scene = scene::random_scene(choices_of(families), own);
    scene::RandomStream random(picture_seed(own.seed, 1));
    change(scene, random);
    return picture_of(scene);
  };
  return set;
}

}  // namespace tagmint::bench
