#pragma once

#include "scene/json_reader.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// A pose from `pose` or from `position_m` and `rotation_deg` of a tag or board (docs/scenes.md).
/// Throws InputError naming the place of a fault.
detect::Pose read_pose(const JsonValue& value);

}  // namespace tagmint::scene
