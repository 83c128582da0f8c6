#pragma once

#include <optional>

#include "pipeline/stage_types.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage T6: corners from the bitmap -> sides that follow the gray values.
struct EdgeOptions {
  double min_side_px = 5;  ///< quads with a smaller mean side are refused, px of the image
};

/// Fits each side again. At most kMaxEdgeScans = 32 scan lines cross a side along rows or columns
/// of the image, whichever crosses it more squarely. Each reads 8 pixels, without interpolation;
/// the side's gray level is half-way between the mean of their darkest and the mean of their
/// brightest, and the place where a scan line passes it, nearest to the side, is a point of the
/// edge. A regression over these places, and a second one that lets go of outliers, gives the
/// side's line; neighbouring lines meet in the corners.
///   image    pixels outside it are taken from its edge
///   quad     counter-clockwise as seen, px of the image, right to about 3 px
///   returns  nothing where a side has no straight edge, or the quad is none
///   cost     8 pixels for each of at most 32 scan lines a side; integer sums, so that the result
///            depends on nothing else
std::optional<Quad> fit_edges(ImageView image, const Quad& quad, const EdgeOptions& options);

}  // namespace tagmint::detect
