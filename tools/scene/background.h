#pragma once

#include <cstdint>
#include <vector>

#include "scene/fill.h"
#include "scene/gray_plane.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// The picture behind the tags, even within a pixel; nothing where it is made of shapes, see
/// background_patches(). Runs on the threads of the task arena that it is called in.
///   seed   of the scene; a texture depends on it
GrayPlane draw_background(const Background& background, int width, int height, std::uint64_t seed);

/// The shapes that a background is made of, in the order in which they lie over one another; none
/// for other backgrounds.
std::vector<Patch> background_patches(const Background& background, int width, int height,
                                      std::uint64_t seed);

/// Position along a direction, from 0 at the first corner of the image that the
/// direction meets to 1 at the last: what gradients and shading are linear in.
class Ramp {
 public:
  /// angle_deg: 0 = to the right, 90 = downwards.
  Ramp(int width, int height, double angle_deg);
  /// Of a place, px.
  double at(double x, double y) const { return offset_ + x * per_x_ + y * per_y_; }

 private:
  double per_x_ = 0;
  double per_y_ = 0;
  double offset_ = 0;
};

}  // namespace tagmint::scene
