#include "scene/clutter.h"

#include <cmath>
#include <numbers>

#include "scene/counter_random.h"

namespace tagmint::scene {
namespace {

using detect::Point;

/// Corners on an ellipse of the given longest diameter, clockwise as seen, in random places.
std::vector<Point> random_shape(Point centre, double size_px, RandomStream& random) {
  constexpr double kMostTurns = 0.8;  // of a corner within its share of the ellipse
  const std::uint64_t corners = 3 + random.below(4);
  const double flatness = random.uniform(0.25, 1);
  const double turn = random.uniform(0, 2 * std::numbers::pi);
  const Point along{std::cos(turn), std::sin(turn)};
  const Point across{-along.y, along.x};
  std::vector<Point> shape;
  for (std::uint64_t i = 0; i < corners; ++i) {
    const double share = static_cast<double>(i) + kMostTurns * random.uniform(0, 1);
    const double angle = 2 * std::numbers::pi * share / static_cast<double>(corners);
    shape.push_back(centre +
                    size_px / 2 * (std::cos(angle) * along + flatness * std::sin(angle) * across));
  }
  return shape;
}

}  // namespace

std::vector<Patch> clutter_patches(const ClutterBackground& clutter, int width, int height,
                                   std::uint64_t seed) {
  constexpr std::uint64_t kStream = 29;  // apart from those of noise, texture and random scenes
  RandomStream random(mix_bits(seed) + kStream);
  const double right = width, bottom = height;
  std::vector<Patch> patches = {
      {{{0, 0}, {right, 0}, {right, bottom}, {0, bottom}}, random.uniform(0, 255)}};
  for (int i = 0; i < clutter.shapes; ++i) {
    // Sizes spread evenly over their logarithm, from the largest down.
    const double place = (i + 0.5) / clutter.shapes;
    const double size_px = clutter.max_px * std::pow(clutter.min_px / clutter.max_px, place);
    const Point centre{random.uniform(0, right), random.uniform(0, bottom)};
    std::vector<Point> shape = random_shape(centre, size_px, random);
    patches.push_back({std::move(shape), random.uniform(0, 255)});
  }
  return patches;
}

}  // namespace tagmint::scene
