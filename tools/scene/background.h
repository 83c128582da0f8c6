#pragma once

#include <cstdint>

#include "scene/gray_plane.h"
#include "scene/scene.h"

namespace tagmint::scene {

/// The picture behind the tags. `seed` is that of the scene; a texture and clutter depend on it.
GrayPlane draw_background(const Background& background, int width, int height, std::uint64_t seed);

/// Position of pixel centres along a direction, from 0 at the first corner of the image that the
/// direction meets to 1 at the last: what gradients and shading are linear in.
class Ramp {
 public:
  /// angle_deg: 0 = to the right, 90 = downwards.
  Ramp(int width, int height, double angle_deg);
  double at(int x, int y) const { return offset_ + x * per_x_ + y * per_y_; }

 private:
  double per_x_ = 0;
  double per_y_ = 0;
  double offset_ = 0;
};

}  // namespace tagmint::scene
