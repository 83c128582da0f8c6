#include "detector/drawn_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/counter_random.h"
#include "scene/render.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::bench {

using detect::Corners;
using detect::Point;

std::uint64_t picture_seed(std::uint64_t seed, int index) {
  return scene::random_word(seed, static_cast<std::uint64_t>(index));
}

Picture picture_of(const scene::Scene& scene) {
  scene::Rendering rendering = scene::render(scene);
  Picture picture{std::move(rendering.image), {}};
  for (std::size_t i = 0; i < scene.tags.size(); ++i) {
    picture.tags.push_back(
        {scene.tags[i].family->name(), scene.tags[i].id, rendering.truth[i].corners});
  }
  return picture;
}

std::vector<scene::TagChoice> choices_of(std::span<const std::string> families) {
  std::vector<scene::TagChoice> choices;
  for (const std::string& name : families) choices.push_back({codec::find_family(name), {}});
  return choices;
}

scene::Effects camera_effects(double noise, double blur_px) {
  scene::Effects effects;
  effects.blur_sigma_px = blur_px;
  effects.noise_sigma = noise;
  return effects;
}

Corners turned_square(Point centre, double side_px, double angle_rad) {
  const Point along{std::cos(angle_rad), std::sin(angle_rad)};
  const Point across{-along.y, along.x};
  Corners corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point p = side_px / 2 * detect::kTagCorners[k];
    corners[k] = centre + p.x * along + p.y * across;
  }
  return corners;
}

scene::Scene grid_scene(double side_px, int quiet_zone_cells, const PictureSize& largest,
                        std::uint64_t seed) {
  constexpr int kColumns = 16;
  constexpr int kRows = 12;
  // Eight cells, the white ring and the quiet zone on both sides, along the diagonal.
  const double pitch = std::numbers::sqrt2 * (10 + 2 * quiet_zone_cells) / 8 * side_px + 4;
  const int columns = std::clamp(static_cast<int>(largest.width / pitch), 1, kColumns);
  const int rows = std::clamp(static_cast<int>(largest.height / pitch), 1, kRows);
  scene::Scene scene;
  scene.width = static_cast<int>(std::ceil(columns * pitch));
  scene.height = static_cast<int>(std::ceil(rows * pitch));
  scene.camera = scene::default_camera(scene.width, scene.height);
  scene.background = scene::PlainBackground{130};
  scene.quiet_zone_cells = quiet_zone_cells;
  scene.seed = seed;
  scene::RandomStream random(scene::mix_bits(seed));
  const codec::SharedFamily family = codec::find_family("tag36h11");
  for (int i = 0; i < columns * rows; ++i) {
    const Point centre{(i % columns + 0.5) * pitch + random.uniform(-0.5, 0.5),
                       (i / columns + 0.5) * pitch + random.uniform(-0.5, 0.5)};
    const double turn = random.uniform(0, 2 * std::numbers::pi);
    const auto id = static_cast<codec::TagId>(random.below(family->size()));
    scene.tags.push_back({family, id, turned_square(centre, side_px, turn)});
  }
  return scene;
}

}  // namespace tagmint::bench
