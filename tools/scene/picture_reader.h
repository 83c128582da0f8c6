#pragma once

#include <filesystem>
#include <vector>

#include "scene/json_reader.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// Parts of a scene file that make the picture around the tags (docs/scenes.md). All throw
/// InputError naming the place of a fault.

/// `folder` is where the paths of photographs start.
Background read_background(const JsonValue& value, const std::filesystem::path& folder);
std::vector<Mark> read_marks(const JsonValue& value);
/// From the keys of the scene itself.
Effects read_effects(const JsonValue& root);

}  // namespace tagmint::scene
