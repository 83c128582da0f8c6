#include "evaluate/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/counter_random.h"
#include "scene/projection.h"
#include "scene/random_scene.h"
#include "scene/rotation.h"

namespace tagmint::evaluate {
namespace {

using detect::Point;
using scene::RandomStream;

constexpr double kBlur_px = 0.7;
constexpr double kNoise = 2;

/// Half the side of a tag's paper, in halves of its border square.
double paper_reach(const codec::Layout& layout, int quiet_zone_cells) {
  return static_cast<double>(layout.width() + 2 * quiet_zone_cells) / layout.width_at_border();
}

codec::TagId any_id(const codec::Family& family, RandomStream& random) {
  return static_cast<codec::TagId>(random.below(family.size()));
}

}  // namespace

detect::Camera usual_camera() {
  return {.fx = kFocal_px, .fy = kFocal_px, .cx = kWidth_px / 2.0, .cy = kHeight_px / 2.0};
}

scene::Effects usual_effects() {
  scene::Effects effects;
  effects.black = 30;
  effects.white = 220;
  effects.blur_sigma_px = kBlur_px;
  effects.noise_sigma = kNoise;
  return effects;
}

std::string usual_conditions() {
  return fmt::format(
      "gray levels 30 and 220, blur {} px, Gaussian noise {} gray levels, "
      "a smooth texture behind the tags",
      kBlur_px, kNoise);
}

std::uint64_t picture_seed(std::uint64_t seed, std::uint64_t point, int picture) {
  return scene::random_word(scene::random_word(seed, point), static_cast<std::uint64_t>(picture));
}

scene::Scene empty_scene(std::uint64_t seed) {
  scene::Scene scene;
  scene.width = kWidth_px;
  scene.height = kHeight_px;
  scene.camera = usual_camera();
  scene.background = scene::TextureBackground{};
  scene.effects = usual_effects();
  scene.seed = seed;
  return scene;
}

scene::Scene frontal_scene(const codec::SharedFamily& family, double distance_m, int most,
                           std::uint64_t seed) {
  constexpr int kTries = 200;
  scene::Scene scene = empty_scene(seed);
  RandomStream random(seed);
  const double reach = paper_reach(family->layout(), scene.quiet_zone_cells);
  std::vector<Point> middles;
  for (int i = 0; i < kTries && static_cast<int>(scene.tags.size()) < most; ++i) {
    const Point at{random.uniform(0, kWidth_px), random.uniform(0, kHeight_px)};
    const double turn_deg = random.uniform(0, 360);
    const codec::TagId id = any_id(*family, random);
    const Point n = scene.camera.to_normalised(at);
    const double z = distance_m / std::hypot(n.x, n.y, 1.0);
    const scene::PosedTag posed{
        .pose = {.R = scene::rotation_from_angles({0, 0, turn_deg}), .t = {n.x * z, n.y * z, z}},
        .edge_m = kEdge_m};
    // The paper's corners lie on this circle about its middle, whatever the turn.
    const double radius_px = std::sqrt(2.0) * reach * kFocal_px * kEdge_m / 2 / z;
    const bool whole = at.x > radius_px && at.y > radius_px && at.x < kWidth_px - radius_px &&
                       at.y < kHeight_px - radius_px;
    bool apart = true;
    for (const Point& other : middles) apart = apart && length(at - other) > 2 * radius_px;
    if (!apart) continue;
    // A tag so near that its circle leaves the picture stands upright in the middle.
    if (!whole && radius_px < kHeight_px / 2.0) continue;
    if (!whole) {
      scene.tags.push_back(
          {family, id, scene::PosedTag{.pose = {.t = {0, 0, distance_m}}, .edge_m = kEdge_m}});
      break;
    }
    scene.tags.push_back({family, id, posed});
    middles.push_back(at);
  }
  return scene;
}

scene::Scene tilted_scene(const codec::SharedFamily& family, double distance_m, double off_axis_deg,
                          std::uint64_t seed) {
  scene::Scene scene = empty_scene(seed);
  RandomStream random(seed);
  const codec::TagId id = any_id(*family, random);
  // Turned in its plane, tilted, and the direction of the tilt turned at random.
  const auto in_plane = scene::rotation_from_angles({0, 0, random.uniform(0, 360)});
  const auto tilt = scene::rotation_from_angles({off_axis_deg, 0, 0});
  const auto direction = scene::rotation_from_angles({0, 0, random.uniform(0, 360)});
  scene::PosedTag posed{.pose = {}, .edge_m = kEdge_m};
  posed.pose.R = scene::multiply(direction, scene::multiply(tilt, in_plane));
  posed.pose.t = {0, 0, distance_m};
  scene.tags.push_back({family, id, posed});
  return scene;
}

scene::Scene wall_scene(const codec::SharedFamily& family, const Wall& wall, std::uint64_t seed) {
  scene::Scene scene = empty_scene(seed);
  scene.width = wall.width_px;
  scene.height = wall.height_px;
  scene.camera = wall.camera;
  scene.quiet_zone_cells = 0;
  const codec::Layout& layout = family->layout();
  const double pitch_m = kEdge_m * layout.width() / layout.width_at_border();
  const auto R = scene::rotation_from_angles({0, 0, wall.roll_deg});
  for (int i = 0; i < wall.columns * wall.rows; ++i) {
    const double x = (i % wall.columns - (wall.columns - 1) / 2.0) * pitch_m;
    const double y = (i / wall.columns - (wall.rows - 1) / 2.0) * pitch_m;
    scene::PosedTag posed{.pose = {.R = R, .t = {}}, .edge_m = kEdge_m};
    posed.pose.t = {wall.middle_m[0] + R[0] * x + R[1] * y, wall.middle_m[1] + R[3] * x + R[4] * y,
                    wall.middle_m[2]};
    scene.tags.push_back(
        {family, static_cast<codec::TagId>(static_cast<std::size_t>(i) % family->size()), posed});
  }
  return scene;
}

scene::Scene scattered_scene(const codec::SharedFamily& family, const Scatter& scatter,
                             std::uint64_t seed) {
  scene::RandomSceneOptions options;
  options.width = scatter.width_px;
  options.height = scatter.height_px;
  options.count = scatter.count;
  options.min_side_px = scatter.min_side_px;
  options.max_side_px = scatter.max_side_px;
  options.max_tilt_deg = scatter.max_tilt_deg;
  options.effects = usual_effects();
  options.seed = seed;
  if (scatter.clutter) options.background = scene::ClutterBackground{};
  const scene::TagChoice choice{family, {}};
  return scene::random_scene({&choice, 1}, options);
}

scene::Scene clutter_scene(std::uint64_t seed) {
  scene::Scene scene = empty_scene(seed);
  scene.background = scene::ClutterBackground{};
  return scene;
}

void shadow_every_tag(double light, std::uint64_t seed, scene::Scene& scene) {
  constexpr double kFarthest_sides = 0.7;
  constexpr double kReach_sides = 1.1;  // covers the tag's paper
  RandomStream random(scene::random_word(seed, 1));
  for (const scene::SceneTag& tag : scene.tags) {
    const detect::Corners c = scene::TagProjection(tag, scene.camera).corners();
    const double side = std::sqrt(std::abs(signed_area(c)));
    const double direction = random.uniform(0, 2 * std::numbers::pi);
    const Point along{std::cos(direction), std::sin(direction)};
    const Point across{-along.y, along.x};
    const Point middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    const Point edge = middle + (random.uniform(-kFarthest_sides, kFarthest_sides) * side) * across;
    const double reach = kReach_sides * side;
    scene.effects.shadows.push_back(
        {.polygon = {edge - reach * along, edge + reach * along,
                     edge + reach * along + reach * across, edge - reach * along + reach * across},
         .light = light});
  }
}

}  // namespace tagmint::evaluate
