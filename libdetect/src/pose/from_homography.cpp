#include "pose/from_homography.h"

#include <Eigen/Geometry>
#include <cmath>

namespace tagmint::detect {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<RigidPose> pose_from_homography(const Homography& tag_to_plane) {
  const auto column = [&](int j) {
    return Vector3d(tag_to_plane(0, j), tag_to_plane(1, j), tag_to_plane(2, j));
  };
  // The columns' lengths stand for the scale; their geometric mean treats both alike.
  double scale = std::sqrt(column(0).norm() * column(1).norm());
  if (!(scale > 0)) return std::nullopt;
  if (tag_to_plane(2, 2) < 0) scale = -scale;
  Matrix3d R;
  R.col(0) = column(0) / scale;
  R.col(1) = column(1) / scale;
  R.col(2) = R.col(0).cross(R.col(1));
  RigidPose pose;
  pose.R = nearest_rotation(R);
  pose.t = column(2) / scale;
  if (!(pose.t.z() > 0)) return std::nullopt;
  return pose;
}

}  // namespace tagmint::detect
