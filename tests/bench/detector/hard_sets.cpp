#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "detector/drawn_scene.h"
#include "detector/scattered_sets.h"
#include "scene/counter_random.h"
#include "scene/projection.h"

namespace tagmint::bench {
namespace {

using detect::Corners;
using detect::Point;
using scene::RandomSceneOptions;
using scene::RandomStream;
using scene::Scene;

void add_tilted_and_blurred(const PictureSize& size, std::vector<PictureSet>& sets) {
  for (const int tilt : {60, 70, 75, 80}) {
    RandomSceneOptions options = scattered(size, 30, 60, 60);
    options.min_tilt_deg = options.max_tilt_deg = tilt;
    options.background = scene::PlainBackground{130};
    options.effects = camera_effects(2);
    sets.push_back(random_set(fmt::format("tilted-{}", tilt),
                              fmt::format("30 tags of 60 px tilted by {} degrees, noise 2", tilt),
                              options));
  }
  for (const int blur : {1, 2, 3}) {
    RandomSceneOptions options = scattered(size, 30, 20, 60);
    options.effects = camera_effects(2, blur);
    sets.push_back(random_set(
        fmt::format("blurred-{}", blur),
        fmt::format("30 tags of 20 to 60 px on clutter, blur {} px, noise 2", blur), options));
  }
}

Corners corners_of(const scene::SceneTag& tag, const Scene& scene) {
  return scene::TagProjection(tag.place, scene.camera).corners();
}
Point middle_of(const Corners& c) { return 0.25 * (c[0] + c[1] + c[2] + c[3]); }
double side_of(const Corners& c) { return std::sqrt(std::abs(signed_area(c))); }

/// A shadow on each tag: a square whose one side passes the tag's middle within 0.7 sides, in any
/// direction, wide enough for the tag's paper.
void shadow_every_tag(double light, Scene& scene, RandomStream& random) {
  for (const scene::SceneTag& tag : scene.tags) {
    const Corners corners = corners_of(tag, scene);
    const double side = side_of(corners);
    const double direction = random.uniform(0, 2 * std::numbers::pi);
    const Point along{std::cos(direction), std::sin(direction)};
    const Point across{-along.y, along.x};
    const Point edge = middle_of(corners) + random.uniform(-0.7, 0.7) * side * across;
    const double reach = 1.1 * side;
    scene.effects.shadows.push_back(
        {.polygon = {edge - reach * along, edge + reach * along,
                     edge + reach * along + reach * across, edge - reach * along + reach * across},
         .light = light});
  }
}

/// A place on the edge of a tag's border, and the direction outwards.
std::pair<Point, Point> place_on_border(const Corners& corners, RandomStream& random) {
  const std::size_t k = random.below(4);
  const Point from = corners[k], to = corners[(k + 1) % 4];
  const Point on = from + random.uniform(0.15, 0.85) * (to - from);
  const Point outwards = on - middle_of(corners);
  return {on, (1 / length(outwards)) * outwards};
}

/// Three specks a tag on its border's edge, up to half a cell wide, dark or light.
void speck_every_tag(Scene& scene, RandomStream& random) {
  for (const scene::SceneTag& tag : scene.tags) {
    const Corners corners = corners_of(tag, scene);
    const double cell = side_of(corners) / tag.family->layout().width_at_border();
    for (int i = 0; i < 3; ++i) {
      const Point on = place_on_border(corners, random).first;
      scene.marks.push_back({.path = {on},
                             .width_px = random.uniform(0.3, 1) * cell,
                             .gray = random.below(2) == 0 ? 30.0 : 220.0});
    }
  }
}

/// A pen's stroke from each tag's border outwards over the paper's edge, a third of a cell wide.
void stroke_every_tag(Scene& scene, RandomStream& random) {
  for (const scene::SceneTag& tag : scene.tags) {
    const Corners corners = corners_of(tag, scene);
    const double cell = side_of(corners) / tag.family->layout().width_at_border();
    const auto [on, outwards] = place_on_border(corners, random);
    scene.marks.push_back({.path = {on - 0.3 * cell * outwards, on + 2.5 * cell * outwards},
                           .width_px = std::max(1.0, cell / 3),
                           .gray = 30});
  }
}

/// A lamp's reflection on each tag, a quarter of its side wide.
void glare_on_every_tag(Scene& scene, RandomStream& random) {
  for (const scene::SceneTag& tag : scene.tags) {
    const Corners corners = corners_of(tag, scene);
    const double side = side_of(corners);
    const Point offset{random.uniform(-0.5, 0.5) * side, random.uniform(-0.5, 0.5) * side};
    scene.effects.glare.push_back(
        {.centre = middle_of(corners) + offset, .radius_px = 0.12 * side, .strength = 150});
  }
}

/// Tags along the picture's edges in any turn, cut by up to a quarter of a cell.
Scene cut_scene(const PictureSize& size, std::uint64_t seed) {
  constexpr double kSide_px = 60;
  constexpr double kPitch_px = 130;
  RandomSceneOptions options = scattered(size, 0, 40, 100);
  options.seed = seed;
  Scene scene = scene::random_scene(choices_of(std::vector<std::string>{"tag36h11"}), options);
  RandomStream random(seed);
  const codec::SharedFamily family = choices_of(std::vector<std::string>{"tag36h11"})[0].family;
  const double cell = kSide_px / family->layout().width_at_border();
  const auto add = [&](double along, int edge) {
    const Corners turned = turned_square({0, 0}, kSide_px, random.uniform(0, 2 * std::numbers::pi));
    double least = 0;  // the tag's extent on the side of the edge
    for (const Point p : turned) least = std::min(least, p.x);
    const double depth = -least - random.uniform(0, 0.25) * cell;
    const double w = size.width, h = size.height;
    Corners corners;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point p{turned[k].x + depth, turned[k].y + along};  // edge 0: the left one
      corners[k] = edge == 0   ? p
                   : edge == 1 ? Point{w - p.x, h - p.y}
                   : edge == 2 ? Point{w - p.y, p.x}
                               : Point{p.y, h - p.x};
    }
    const auto id = static_cast<codec::TagId>(random.below(family->size()));
    scene.tags.push_back({family, id, corners});
  };
  for (double y = kPitch_px; y < size.height - kPitch_px; y += kPitch_px) {
    add(y, 0);
    add(y, 1);
  }
  for (double x = kPitch_px; x < size.width - kPitch_px; x += kPitch_px) {
    add(x, 2);
    add(x, 3);
  }
  return scene;
}

void add_lit_and_marked(const PictureSize& size, std::vector<PictureSet>& sets) {
  RandomSceneOptions options = scattered(size, 30, 40, 100);
  options.effects = camera_effects(2);
  for (const int percent : {50, 40}) {
    const double light = percent / 100.0;
    sets.push_back(changed_set(fmt::format("shadow-{}", percent),
                               fmt::format("30 tags of 40 to 100 px, a shadow of {} % light "
                                           "across each, noise 2",
                                           percent),
                               options, [light](Scene& scene, RandomStream& random) {
                                 shadow_every_tag(light, scene, random);
                               }));
  }
  sets.push_back(changed_set("specks", "three specks of up to a cell on the border of each tag",
                             options, speck_every_tag));
  sets.push_back(changed_set("strokes", "a pen's stroke out of the border of each tag", options,
                             stroke_every_tag));
  sets.push_back(
      changed_set("glare", "a lamp's reflection on each tag", options, glare_on_every_tag));
}

void add_effects_of_cameras(const PictureSize& size, std::vector<PictureSet>& sets) {
  PictureSet cut{.name = "cut",
                 .about = "tags of 60 px at the picture's edges, cut by up to a quarter of a cell"};
  cut.draw = [size](int index, std::uint64_t seed) {
    return picture_of(cut_scene(size, picture_seed(seed, index)));
  };
  sets.push_back(std::move(cut));
  RandomSceneOptions curved = scattered(size, 12, 100, 250);
  curved.camera = scene::default_camera(size.width, size.height);
  curved.camera->fx = curved.camera->fy = 0.6 * size.width;
  curved.camera->k1 = -0.22;
  curved.camera->k2 = 0.04;
  curved.effects = camera_effects(2);
  sets.push_back(random_set("curved",
                            "12 tags of 100 to 250 px through a wide lens, k1 -0.22, "
                            "k2 0.04",
                            curved));
  for (const int length : {4, 8}) {
    RandomSceneOptions moved = scattered(size, 30, 40, 100);
    moved.effects = camera_effects(2);
    sets.push_back(changed_set(fmt::format("moved-{}", length),
                               fmt::format("motion blur of {} px in any direction", length), moved,
                               [length](Scene& scene, RandomStream& random) {
                                 scene.effects.motion_blur = {.length_px = double(length),
                                                              .angle_deg = random.uniform(0, 180)};
                               }));
  }
  RandomSceneOptions gamma = scattered(size, 30, 20, 100);
  gamma.effects = camera_effects(2);
  gamma.effects.gamma = 2.2;
  gamma.effects.black = 6;
  gamma.effects.white = 190;
  gamma.effects.vignetting = 0.4;
  sets.push_back(random_set("gamma", "30 tags of 20 to 100 px, gamma 2.2, vignetting 0.4", gamma));
}

}  // namespace

std::vector<PictureSet> hard_sets(const PictureSize& size) {
  std::vector<PictureSet> sets;
  add_tilted_and_blurred(size, sets);
  add_lit_and_marked(size, sets);
  add_effects_of_cameras(size, sets);
  return sets;
}

}  // namespace tagmint::bench
