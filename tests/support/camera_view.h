#pragma once

#include <cstdint>

#include "tagmint/detect/homography.h"
#include "tagmint/detect/image.h"

namespace tagmint::test {

/// How a camera sees a flat picture.
struct CameraView {
  int width = 960;
  int height = 720;
  double tilt_deg = 30;  ///< of the picture, about an axis in the image plane
  double axis_deg = 60;  ///< direction of that axis
  double roll_deg = 8;   ///< clockwise as seen
  double fill = 0.8;     ///< share of the image that the picture takes when it is not tilted
  double blur_sigma_px = 0.6;
  double noise_sigma = 2;
  double black = 30;
  double white = 215;
  double surround = 120;  ///< gray beyond the picture
};

/// The map from the picture's pixels to the image's.
detect::Homography picture_to_image(const detect::Image& picture, const CameraView& view);

/// The picture as the camera sees it: the mean over 9 places of each pixel, blurred, with noise.
detect::Image seen_by_camera(const detect::Image& picture, const CameraView& view,
                             std::uint64_t seed = 1);

}  // namespace tagmint::test
