#pragma once

#include <optional>
#include <vector>

#include "scene/gray_plane.h"
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
  /// another tag's paper, 0..1; marks and light are not counted.
  double visible = 0;
};

struct Rendering {
  detect::Image image;
  std::vector<TagTruth> truth;  ///< one for each tag of the scene, in its order
};

/// Draws a scene. Every pixel is the mean of what its square sees: edges are exact polygon areas,
/// not samples. Black, white and background are even inside each cell, so shading is applied to
/// whole pixels afterwards.
///   threads   0 = all cores; the result does not depend on it
///   errors    std::invalid_argument as check_scene()
///   cost      some ten operations a pixel, and the pixels of each tag three times
Rendering render(const Scene& scene, int threads = 0);

/// The picture before the effects, in gray levels, and the truth; one thread.
struct Drawing {
  GrayPlane plane;
  std::vector<TagTruth> truth;
};
Drawing draw_tags(const Scene& scene);

}  // namespace tagmint::scene
