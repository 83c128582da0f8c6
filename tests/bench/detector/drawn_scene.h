#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "detector/picture_set.h"
#include "scene/random_scene.h"

namespace tagmint::bench {

/// A seed for picture `index` of a run, apart from those of other pictures and runs.
std::uint64_t picture_seed(std::uint64_t seed, int index);

/// The picture of a scene and the truth of all its tags.
Picture picture_of(const scene::Scene& scene);

/// All ids of the bundled families named.
std::vector<scene::TagChoice> choices_of(std::span<const std::string> families);

/// Black 30, white 220 and a sharp camera: blur 0.7 px, noise `noise` gray levels.
scene::Effects camera_effects(double noise, double blur_px = 0.7);

/// Tags of tag36h11 in a grid, each turned and moved by up to half a pixel at random, on plain
/// gray: as many as fit, 192 at most. The picture is as large as they need.
///   side_px            of the border squares, seen from the front
///   quiet_zone_cells   around the white ring of one cell that is the tag's own
scene::Scene grid_scene(double side_px, int quiet_zone_cells, const PictureSize& largest,
                        std::uint64_t seed);

/// Corners of a square of the given side about `centre`, turned clockwise as seen.
detect::Corners turned_square(detect::Point centre, double side_px, double angle_rad);

}  // namespace tagmint::bench
