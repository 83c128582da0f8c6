#include "scene/random_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "scene/counter_random.h"
#include "scene/projection.h"
#include "scene/rotation.h"

namespace tagmint::scene {
namespace {

using detect::Corners;
using detect::Point;

void check_options(std::span<const TagChoice> choices, const RandomSceneOptions& options) {
  const auto require = [](bool holds, const std::string& message) {
    if (!holds) throw std::invalid_argument(message);
  };
  require(!choices.empty(), "no family was given; name at least one");
  require(options.count >= 0, fmt::format("the count is {}; it must be 0 or more", options.count));
  require(options.min_side_px > 0 && options.max_side_px >= options.min_side_px &&
              std::isfinite(options.max_side_px),
          fmt::format("the sides run from {} to {} px; the smallest must be above 0 and the "
                      "largest not below it",
                      options.min_side_px, options.max_side_px));
  require(
      options.max_tilt_deg >= 0 && options.max_tilt_deg <= 85,
      fmt::format("the largest tilt is {} degrees; it must be from 0 to 85", options.max_tilt_deg));
  require(options.min_tilt_deg >= 0 && options.min_tilt_deg <= options.max_tilt_deg,
          fmt::format("the tilts run from {} to {} degrees; the smallest must be from 0 to the "
                      "largest",
                      options.min_tilt_deg, options.max_tilt_deg));
  require(options.edge_m > 0 && std::isfinite(options.edge_m), "the edge must be above 0");
}

/// The ids of one family in random order, again and again.
class Dealer {
 public:
  Dealer(const TagChoice& choice, std::uint64_t seed) : family_(choice.family), ids_(choice.ids) {
    if (ids_.empty()) {
      ids_.resize(family_->size());
      std::iota(ids_.begin(), ids_.end(), codec::TagId{0});
    }
    RandomStream random(seed);
    for (std::size_t i = ids_.size(); i > 1; --i) std::swap(ids_[i - 1], ids_[random.below(i)]);
  }
  SceneTag deal() {
    SceneTag tag;
    tag.family = family_;
    tag.id = ids_[next_++ % ids_.size()];
    return tag;
  }

 private:
  codec::SharedFamily family_;
  std::vector<codec::TagId> ids_;
  std::size_t next_ = 0;
};

/// A rotation by `angle` radians about the unit axis (x, y, z) [Rodrigues].
std::array<double, 9> about_axis(double x, double y, double z, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double v = 1 - c;
  return {c + x * x * v,     x * y * v - z * s, x * z * v + y * s, y * x * v + z * s, c + y * y * v,
          y * z * v - x * s, z * x * v - y * s, z * y * v + x * s, c + z * z * v};
}

/// A pose whose middle is seen at `pixel`, tilted against the line of sight to it.
detect::Pose random_pose(Point pixel, double side_px, const RandomSceneOptions& options,
                         const detect::Camera& camera, RandomStream& random) {
  const Point ray = camera.to_normalised(pixel);
  const double distance = camera.fx * options.edge_m / side_px;
  const double ray_length = std::hypot(ray.x, ray.y, 1);
  // First a turn in the plane, then the tilt about a random axis in it, then as the line of sight.
  const double turn = random.uniform(0, 2 * std::numbers::pi);
  const double direction = random.uniform(0, 2 * std::numbers::pi);
  constexpr double kRadians = std::numbers::pi / 180;
  const double tilt = std::acos(random.uniform(std::cos(options.max_tilt_deg * kRadians),
                                               std::cos(options.min_tilt_deg * kRadians)));
  const double off_axis = std::hypot(ray.x, ray.y);
  const auto sight = off_axis > 0
                         ? about_axis(-ray.y / off_axis, ray.x / off_axis, 0, std::atan(off_axis))
                         : about_axis(0, 0, 1, 0);
  detect::Pose pose;
  pose.R = multiply(sight, multiply(about_axis(std::cos(direction), std::sin(direction), 0, tilt),
                                    about_axis(0, 0, 1, turn)));
  const double scale = distance / ray_length;
  pose.t = {ray.x * scale, ray.y * scale, scale};
  return pose;
}

/// The corners of the tag's paper, quiet zone included, px; nothing when it comes too near.
std::optional<Corners> paper_corners(const SceneTag& tag, const RandomSceneOptions& options,
                                     const detect::Camera& camera) {
  const TagProjection projection(tag.place, camera);
  const codec::Layout& layout = tag.family->layout();
  const double half = (layout.width() + 2.0 * options.quiet_zone_cells) / layout.width_at_border();
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = half * detect::kTagCorners[i];
    if (projection.depth(p) < 0.1) return std::nullopt;
    corners[i] = projection.project(p);
  }
  return corners;
}

bool inside_image(const Corners& corners, int width, int height) {
  return std::all_of(corners.begin(), corners.end(), [&](Point p) {
    return p.x >= 1 && p.y >= 1 && p.x <= width - 1 && p.y <= height - 1;
  });
}

/// Whether some side of `a` has all of `b` on its outer side; corners counter-clockwise as seen.
bool side_separates(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Point from = a[i];
    const Point along = a[(i + 1) % 4] - from;
    if (std::all_of(b.begin(), b.end(), [&](Point p) { return cross(along, p - from) > 0; })) {
      return true;
    }
  }
  return false;
}

bool overlap(const Corners& a, const Corners& b) {
  return !side_separates(a, b) && !side_separates(b, a);
}

/// Tries places at random until the tag is whole and touches no other.
bool place(SceneTag& tag, double side_px, const RandomSceneOptions& options,
           const detect::Camera& camera, RandomStream& random, std::vector<Corners>& taken) {
  constexpr int kTries = 400;  // a free place of 1 % of the image is missed once in 56 tags
  for (int i = 0; i < kTries; ++i) {
    const Point pixel{random.uniform(0, options.width), random.uniform(0, options.height)};
    tag.place = PosedTag{random_pose(pixel, side_px, options, camera, random), options.edge_m};
    const auto corners = paper_corners(tag, options, camera);
    if (!corners || !inside_image(*corners, options.width, options.height)) continue;
    const auto touches = [&](const Corners& other) { return overlap(*corners, other); };
    if (std::any_of(taken.begin(), taken.end(), touches)) continue;
    taken.push_back(*corners);
    return true;
  }
  return false;
}

}  // namespace

Scene random_scene(std::span<const TagChoice> choices, const RandomSceneOptions& options) {
  check_options(choices, options);
  Scene scene;
  scene.width = options.width;
  scene.height = options.height;
  scene.camera = options.camera.value_or(default_camera(options.width, options.height));
  scene.background = options.background;
  scene.quiet_zone_cells = options.quiet_zone_cells;
  scene.effects = options.effects;
  scene.seed = options.seed;

  RandomStream random(mix_bits(options.seed + 17));  // apart from the streams of noise and texture
  std::vector<Dealer> dealers;
  for (const TagChoice& choice : choices) dealers.emplace_back(choice, random.word());
  // The large ones first: small ones still find room between them.
  std::vector<double> sides(static_cast<std::size_t>(options.count));
  for (double& side : sides) {
    side = options.min_side_px *
           std::pow(options.max_side_px / options.min_side_px, random.uniform(0, 1));
  }
  std::sort(sides.begin(), sides.end(), std::greater<>());
  std::vector<Corners> taken;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    SceneTag tag = dealers[i % dealers.size()].deal();
    if (place(tag, sides[i], options, scene.camera, random, taken)) scene.tags.push_back(tag);
  }
  check_scene(scene);
  return scene;
}

}  // namespace tagmint::scene
