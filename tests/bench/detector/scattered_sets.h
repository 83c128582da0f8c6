#pragma once

#include <functional>
#include <string>

#include "detector/picture_set.h"
#include "scene/counter_random.h"
#include "scene/random_scene.h"

namespace tagmint::bench {

/// `count` tags over a picture of clutter, noise 5, tilted by up to 50 degrees.
scene::RandomSceneOptions scattered(const PictureSize& size, int count, double min_side_px,
                                    double max_side_px);

/// A set of random scenes that differ in their seed.
PictureSet random_set(std::string name, std::string about, const scene::RandomSceneOptions& options,
                      Task task = {});

/// The same, each scene changed by `change` before it is drawn: by its own random numbers, which
/// depend on the picture's seed alone.
using SceneChange = std::function<void(scene::Scene&, scene::RandomStream&)>;
PictureSet changed_set(std::string name, std::string about,
                       const scene::RandomSceneOptions& options, SceneChange change);

/// Pictures that are hard to read: tilted, blurred, shadowed, marked, cut, curved, moved, glaring.
std::vector<PictureSet> hard_sets(const PictureSize& size);

}  // namespace tagmint::bench
