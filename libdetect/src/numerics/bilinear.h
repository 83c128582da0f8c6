#pragma once

#include <algorithm>
#include <optional>

#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Whether p lies in the image area [0, width] x [0, height].
inline bool contains(ImageView image, Point p) {
  return p.x >= 0 && p.y >= 0 && p.x <= image.width && p.y <= image.height;
}

/// Gray value at p, 0..255, between the centres of the four nearest pixels.
///   p        at least half a pixel inside the image's edges
///   cost     four pixels, no questions asked: for loops that have checked both ends of a line
inline double sample_inside(ImageView image, Point p) {
  // Pixel (i, j) has its value at its centre (i + 0.5, j + 0.5).
  const double u = p.x - 0.5;
  const double v = p.y - 0.5;
  // On the last column or row the pixel beyond has no weight; the one before stands in for it.
  const int x = std::min(static_cast<int>(u), image.width - 2);
  const int y = std::min(static_cast<int>(v), image.height - 2);
  const double fx = u - x;
  const double fy = v - y;
  const std::uint8_t* top = image.row(y) + x;
  const std::uint8_t* bottom = image.row(y + 1) + x;
  return (1 - fy) * ((1 - fx) * top[0] + fx * top[1]) +
         fy * ((1 - fx) * bottom[0] + fx * bottom[1]);
}

/// Whether p is where sample_inside() may look.
inline bool well_inside(ImageView image, Point p) {
  return image.width >= 2 && image.height >= 2 && p.x >= 0.5 && p.y >= 0.5 &&
         p.x <= image.width - 0.5 && p.y <= image.height - 0.5;
}

/// Gray value at p, 0..255, between the centres of the four nearest pixels. In the half pixel along
/// the image's edge the outermost pixels go on; outside the image there is no value.
///   cost     four pixels
inline std::optional<double> sample_bilinear(ImageView image, Point p) {
  if (image.empty() || !contains(image, p)) return std::nullopt;
  if (well_inside(image, p)) return sample_inside(image, p);
  const double u = std::clamp(p.x - 0.5, 0.0, image.width - 1.0);
  const double v = std::clamp(p.y - 0.5, 0.0, image.height - 1.0);
  const int x = static_cast<int>(u);
  const int y = static_cast<int>(v);
  const int right = std::min(x + 1, image.width - 1);
  const double fx = u - x;
  const double fy = v - y;
  const std::uint8_t* top = image.row(y);
  const std::uint8_t* bottom = image.row(std::min(y + 1, image.height - 1));
  return (1 - fy) * ((1 - fx) * top[x] + fx * top[right]) +
         fy * ((1 - fx) * bottom[x] + fx * bottom[right]);
}

}  // namespace tagmint::detect
