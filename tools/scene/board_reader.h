#pragma once

#include "scene/json_reader.h"
#include "scene/scene.h"
#include "scene/scene_families.h"

namespace tagmint::scene {

/// Reads an element of `boards` (docs/scenes.md) and lays it over the sheets and tags that the
/// scene has: its sheet, and each of its tags as one of the scene's. Throws InputError naming the
/// place of a fault, such as a grid that cannot be printed.
void add_board(const JsonValue& value, SceneFamilies& families, Scene& scene);

}  // namespace tagmint::scene
