#include "scene/place_reader.h"

#include "scene/rotation.h"

namespace tagmint::scene {

detect::Pose read_pose(const JsonValue& value) {
  detect::Pose pose;
  if (value.has("pose")) {
    if (value.has("position_m") || value.has("rotation_deg")) {
      value.fail("has a pose and a position or rotation", "give one of them");
    }
    const JsonValue given = value.at("pose");
    given.require_keys({"R", "t"});
    pose.R = given.at("R").numbers<9>();
    pose.t = given.at("t").numbers<3>();
    return pose;
  }
  pose.t = value.at("position_m").numbers<3>();
  if (value.has("rotation_deg")) {
    pose.R = rotation_from_angles(value.at("rotation_deg").numbers<3>());
  }
  return pose;
}

}  // namespace tagmint::scene
