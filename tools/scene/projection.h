#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "tagmint/detect/camera.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/homography.h"

namespace tagmint::scene {

/// The map from one tag's plane, border square = [-1,1]^2 with y down, to the pixels of a scene.
class TagProjection {
 public:
  /// The place must have passed check_scene(), or at least have finite numbers.
  TagProjection(const TagPlace& place, const detect::Camera& camera);
  TagProjection(const SceneTag& tag, const detect::Camera& camera)
      : TagProjection(tag.place, camera) {}

  /// Homogeneous third coordinate of p: positive in front of the camera (scaled so that the middle
  /// of the tag has 1, or -1 behind the camera).
  double depth(detect::Point p) const;
  /// Pixel that shows p; depth(p) must be positive.
  detect::Point project(detect::Point p) const;
  /// Whether straight lines on the tag are curves in the image.
  bool curved() const { return camera_.has_value(); }

  /// The corners of the border square in the order of kTagCorners, px.
  detect::Corners corners() const;
  /// The homography through the four corners, h22 = 1: the map itself where it is not curved().
  /// Nothing when the corners are degenerate.
  std::optional<detect::Homography> homography() const;

  /// Appends the image of the segment from a to b without its end point: one point where the map is
  /// straight, else as many as keep the curve within kChordError of its chords.
  static constexpr double kChordError_px = 2e-4;
  void trace(detect::Point a, detect::Point b, std::vector<detect::Point>& out) const;

 private:
  std::array<double, 9> plane_;           // tag plane -> pixels, or -> camera coordinates if curved
  std::optional<detect::Camera> camera_;  // with distortion, if curved
};

/// The part of a convex polygon on the tag plane that lies in front of the camera, nearer to it
/// than kNearest times the depth of the tag's middle left out.
inline constexpr double kNearest = 1e-3;
std::vector<detect::Point> clip_to_front(const TagProjection& projection,
                                         const std::vector<detect::Point>& polygon);

/// Largest distance from the optical axis, on the normalised image plane, up to which the camera's
/// radial distortion grows outwards; infinite when it always does.
double fold_radius(const detect::Camera& camera);

}  // namespace tagmint::scene
