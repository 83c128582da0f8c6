#pragma once

#include <functional>

#include "refine/photometric_pixels.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Coordinates about a tag in which numbers are about one: frame = (ideal px - origin) / scale.
/// Ideal pixels are those of a camera without distortion; without a lens, the image's own.
struct TagFrame {
  Point origin;
  double scale_px = 1;

  Point to_frame(Point px) const { return (1 / scale_px) * (px - origin); }
  Point to_px(Point frame) const { return origin + scale_px * frame; }
};

/// Which pixels take part.
struct PixelChoice {
  TagFrame frame;
  std::array<double, 8> to_cells{};  ///< as PhotometricParameters::to_cells
  /// How far from a grid line where the colour changes a pixel may lie, px; cells are taken to be
  /// as wide everywhere as in the tag's middle.
  double near_px = 1.7;
  /// Standard deviation of the point-spread, px; pixels into which cells of unknown colour reach
  /// count less.
  double spread_px = 0.6;
  /// One pixel in so many of each row is looked at, in another place of each row.
  int step = 1;
};

/// Where the tag without distortion has its pixel: image px -> ideal px.
struct PixelMapping {
  std::function<Point(Point)> to_ideal;
  double ideal_px_per_px = 1;  ///< length there of a pixel of the image
};

/// The pixels of the tag that tell where its edges are: in a known cell, near a side of it behind
/// which the colour is another.
///   region   convex, holds all known cells; ideal px
///   pixels   takes them, row by row; at most its capacity, for which the caller has made room
///   cost     some 2 ns for each pixel looked at (AVX2)
void choose_pixels(ImageView image, const TagPattern& pattern, const PixelChoice& choice,
                   const Corners& region, PhotometricPixels& pixels);

/// How many pixels choose_pixels() looks at, at most.
std::size_t most_pixels(ImageView image, const Corners& region, int step);

namespace scalar {

/// The plain reference of choose_pixels(), which also works through a lens.
///   region    as above, but in image px
///   mapping   null = the identity
void choose_pixels(ImageView image, const TagPattern& pattern, const PixelChoice& choice,
                   const Corners& region, const PixelMapping* mapping, PhotometricPixels& pixels);

}  // namespace scalar
}  // namespace tagmint::detect
