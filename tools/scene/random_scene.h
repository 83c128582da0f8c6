#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace tagmint::scene {

/// What a random scene is made of.
struct RandomSceneOptions {
  int width = 640;   ///< px
  int height = 480;  ///< px
  int count = 8;     ///< tags, >= 0
  double min_side_px =
      40;  ///< smallest side of a border square as it would look frontally, px, > 0
  double max_side_px = 110;  ///< largest one, >= min_side_px
  double min_tilt_deg = 0;   ///< smallest angle between a tag's normal and the line of sight, 0..85
  double max_tilt_deg = 50;  ///< largest one, >= min_tilt_deg, 0..85
  double edge_m = 0.1;       ///< side of every border square, metres, > 0
  int quiet_zone_cells = 1;
  std::optional<detect::Camera> camera;  ///< default_camera() when not given
  Background background = TextureBackground{};
  Effects effects;
  std::uint64_t seed = 1;
};

/// One family of a random scene and the ids to use.
struct TagChoice {
  codec::SharedFamily family;
  std::vector<codec::TagId> ids;  ///< empty = all
};

/// Scatters tags over the image: whole, apart from each other, sizes spread evenly over their
/// logarithm, tilts evenly over solid angle, any turn. Families take turns; the ids of a family are
/// dealt out in random order and come again only when all were used.
///   returns  a scene with `count` tags, or fewer where no room was found for more
///   errors   std::invalid_argument for an option out of range, no family, or an id that the family
///            lacks
///   cost     O(count^2) in the worst case
Scene random_scene(std::span<const TagChoice> choices, const RandomSceneOptions& options);

}  // namespace tagmint::scene
