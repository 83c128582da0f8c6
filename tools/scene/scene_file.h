#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/render.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// Reads a scene from JSON text (docs/scenes.md); what is left out has its default.
///   source   name used in messages, for example the path
///   folder   where the paths of family files and photographs start
/// Throws InputError naming source and place: not JSON (with the line), an unknown key (with the
/// nearest one), a missing or impossible value, a family or picture that cannot be read, a scene
/// that check_scene() refuses.
Scene parse_scene(std::string_view json, const std::string& source,
                  const std::filesystem::path& folder);

/// Reads a scene file; paths in it start at its folder. Throws InputError as parse_scene() does,
/// and when the file cannot be read.
Scene read_scene(const std::filesystem::path& path);

/// The ground truth of a picture as JSON text (docs/scenes.md), one tag a line. `truth` holds one
/// entry for each tag of the scene.
std::string format_truth(const Scene& scene, std::span<const TagTruth> truth);

}  // namespace tagmint::scene
