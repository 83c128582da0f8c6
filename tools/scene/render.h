#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "tagmint/detect/homography.h"
#include "tagmint/detect/image.h"

namespace tagmint::scene {

/// What is true of one tag of a scene, in the terms of a detection.
struct TagTruth {
  detect::Corners corners;                       ///< of the border square, order of kTagCorners, px
  std::optional<detect::Homography> homography;  ///< through the corners, h22 = 1; missing only
                                                 ///< when the scene's tag has none
  /// Share of the tag's own area (without the quiet zone) that is inside the image and not under
  /// another tag's paper, 0..1; marks, light and blur are not counted.
  double visible = 0;
  double visible_px = 0;  ///< that area, px^2
};

struct Rendering {
  detect::Image image;
  std::string jpeg;  ///< the file that `image` was read from, where the scene asks for it
  std::vector<TagTruth> truth;  ///< one for each tag of the scene, in its order
};

/// Draws a scene. Each sample of a grid, as fine as the optics need and the pixels' own without
/// any, is the mean of what its square sees: edges are exact polygon areas. Optics come before the
/// pixels (PointSpread), noise after.
///   threads   0 = all cores; the result does not depend on it
///   errors    std::invalid_argument as check_scene()
///   cost      some ten operations a sample, and the samples of each tag three times
Rendering render(const Scene& scene, int threads = 0);

}  // namespace tagmint::scene
