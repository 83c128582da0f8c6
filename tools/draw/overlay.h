#pragma once

#include <optional>
#include <span>

#include "io/detections.h"
#include "io/images.h"
#include "tagmint/detect/camera.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::draw {

/// What is needed to draw the axes of poses.
struct AxesSetting {
  detect::Camera camera;
  double edge_m = 0;  ///< side of the border square, metres, > 0
};

/// The picture with what was found in it: the border square outlined in green, a red dot on its
/// first corner, the id in the middle (the family as well where the tags are of several), and,
/// where `axes` is given, the axes of each pose, half an edge long: x red, y green, z blue.
///   picture   at least one pixel
/// Throws codec::OutputError when Cairo cannot hold the picture.
io::RgbImage draw_overlay(const detect::ImageView& picture, std::span<const io::FoundTag> tags,
                          const std::optional<AxesSetting>& axes = {});

}  // namespace tagmint::draw
