#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "refine/choose_pixels.h"
#include "refine/tag_pattern.h"
#include "tagmint/detect/camera.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// Lens or none: image px -> ideal px and back.
Point to_ideal_px(const std::optional<Camera>& lens, Point image_px);
Point to_image_px(const std::optional<Camera>& lens, Point ideal_px);

/// Frame -> cells through the four corners of the border square.
///   ideal_corners   order of kTagCorners, ideal px
std::optional<std::array<double, 8>> map_to_cells(const Corners& ideal_corners,
                                                  const TagFrame& frame, const TagPattern& pattern);

/// The inverse, for places given in cells; nothing where they are not in front of the camera.
std::optional<Corners> places_in_px(const std::array<double, 8>& to_cells, const TagFrame& frame,
                                    const std::array<Point, 4>& cells);

/// The corners of the border square, and of the whole tag less `inset` cells on all sides, in
/// cells; order of kTagCorners.
std::array<Point, 4> border_corners(const TagPattern& pattern);
std::array<Point, 4> outer_corners(const TagPattern& pattern, double inset = 0);

/// d(x0, y0, x1, ... y3) / d to_cells of the border square's corners, ideal px.
Matrix8 corner_jacobian(const std::array<double, 8>& to_cells, const TagFrame& frame,
                        const Corners& ideal_corners, const TagPattern& pattern);

/// d image px / d ideal px at each corner, as a block diagonal matrix; the identity without a lens.
Matrix8 lens_jacobian(const std::optional<Camera>& lens, const Corners& ideal_corners);

}  // namespace tagmint::detect
