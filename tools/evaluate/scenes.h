#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "scene/scene.h"

namespace tagmint::evaluate {

/// The camera and the tags of the experiments in space: 640 x 480 px, focal length 600 px, tags of
/// 0.167 m as in the paper's mosaic. A frontal tag has a side of 100.2 px / distance in metres.
inline constexpr int kWidth_px = 640;
inline constexpr int kHeight_px = 480;
inline constexpr double kFocal_px = 600;
inline constexpr double kEdge_m = 0.167;
detect::Camera usual_camera();

/// Black 30, white 220, blur of 0.7 px, noise of 2 gray levels.
scene::Effects usual_effects();
/// A line that says so.
std::string usual_conditions();

/// A seed for each picture of an experiment.
std::uint64_t picture_seed(std::uint64_t seed, std::uint64_t point, int picture);

/// An empty scene with that camera, those effects and a smooth random texture behind the tags.
scene::Scene empty_scene(std::uint64_t seed);

/// Up to `most` tags of any ids that face the camera (their plane is parallel to the image's, any
/// turn within it), each whole in the picture with its quiet zone and apart from the others, its
/// middle at that distance from the camera's centre, at random places.
scene::Scene frontal_scene(const codec::SharedFamily& family, double distance_m, int most,
                           std::uint64_t seed);

/// One tag whose middle is on the optical axis, its normal that far off the axis in any direction,
/// turned in its plane at random.
scene::Scene tilted_scene(const codec::SharedFamily& family, double distance_m, double off_axis_deg,
                          std::uint64_t seed);

/// A wall of `columns` x `rows` tags, each touching the next, ids one after another and again from
/// 0; the middle of the wall at `middle`, the wall parallel to the image but for a roll.
struct Wall {
  int columns = 11;
  int rows = 9;
  detect::Camera camera;
  int width_px = 0;
  int height_px = 0;
  std::array<double, 3> middle_m{};
  double roll_deg = 0;
};
scene::Scene wall_scene(const codec::SharedFamily& family, const Wall& wall, std::uint64_t seed);

/// Tags scattered over a picture of that size at any tilt up to 40 degrees, sides as asked, on
/// clutter or on texture.
struct Scatter {
  int count = 12;
  double min_side_px = 25;  ///< of the border square, from the front
  double max_side_px = 60;
  double max_tilt_deg = 40;
  bool clutter = true;
  int width_px = kWidth_px;
  int height_px = kHeight_px;
};
scene::Scene scattered_scene(const codec::SharedFamily& family, const Scatter& scatter,
                             std::uint64_t seed);

/// Clutter without a tag.
scene::Scene clutter_scene(std::uint64_t seed);

/// The edge of a hard shadow across each tag of a scene, through its middle or up to 0.7 sides from
/// it, in any direction.
void shadow_every_tag(double light, std::uint64_t seed, scene::Scene& scene);

}  // namespace tagmint::evaluate
