#pragma once

#include <optional>

#include "pose/pose_problem.h"
#include "tagmint/detect/homography.h"

namespace tagmint::detect {

/// The pose that a homography of the tag plane stands for: its columns are, up to one scale, the
/// first two columns of the rotation and the translation. With noisy corners the columns are not
/// quite of one length nor at right angles; the nearest rotation takes their place.
///   tag_to_plane   tag plane in metres -> normalised image plane
///   returns        nothing when the tag's middle would not be in front of the camera
///   source         [Zhang2000, section 3.1]
std::optional<RigidPose> pose_from_homography(const Homography& tag_to_plane);

}  // namespace tagmint::detect
