#include "refine/corner_map.h"

#include <Eigen/LU>

#include "tagmint/detect/homography.h"

namespace tagmint::detect {
namespace {

std::array<Point, 4> square_corners(double begin, double end) {
  return {{{begin, end}, {end, end}, {end, begin}, {begin, begin}}};
}

}  // namespace

Point to_ideal_px(const std::optional<Camera>& lens, Point image_px) {
  if (!lens) return image_px;
  const Point n = lens->to_normalised(image_px);
  return {lens->fx * n.x + lens->cx, lens->fy * n.y + lens->cy};
}

Point to_image_px(const std::optional<Camera>& lens, Point ideal_px) {
  if (!lens) return ideal_px;
  return lens->to_pixel({(ideal_px.x - lens->cx) / lens->fx, (ideal_px.y - lens->cy) / lens->fy});
}

std::array<Point, 4> border_corners(const TagPattern& pattern) {
  return square_corners(pattern.border_begin(), pattern.border_end());
}

std::array<Point, 4> outer_corners(const TagPattern& pattern, double inset) {
  return square_corners(inset, pattern.width() - inset);
}

std::optional<std::array<double, 8>> map_to_cells(const Corners& ideal_corners,
                                                  const TagFrame& frame,
                                                  const TagPattern& pattern) {
  std::array<Point, 4> in_frame;
  for (int i = 0; i < 4; ++i) in_frame[i] = frame.to_frame(ideal_corners[i]);
  const std::optional<Homography> map = Homography::from_points(in_frame, border_corners(pattern));
  if (!map || map->row_major()[8] != 1) return std::nullopt;
  std::array<double, 8> to_cells{};
  for (int i = 0; i < 8; ++i) to_cells[i] = map->row_major()[i];
  return to_cells;
}

std::optional<Corners> places_in_px(const std::array<double, 8>& g, const TagFrame& frame,
                                    const std::array<Point, 4>& cells) {
  Corners places;
  for (int i = 0; i < 4; ++i) {
    // u (g6 x + g7 y + 1) = g0 x + g1 y + g2, and the same of v: two lines that meet in the place.
    const Point c = cells[i];
    const double a = g[0] - c.x * g[6];
    const double b = g[1] - c.x * g[7];
    const double e = g[3] - c.y * g[6];
    const double f = g[4] - c.y * g[7];
    const double determinant = a * f - b * e;
    const Point frame_place = {((c.x - g[2]) * f - b * (c.y - g[5])) / determinant,
                               (a * (c.y - g[5]) - e * (c.x - g[2])) / determinant};
    const double depth = g[6] * frame_place.x + g[7] * frame_place.y + 1;
    if (!(determinant > 0 && depth > 0)) return std::nullopt;
    places[i] = frame.to_px(frame_place);
  }
  return places;
}

Matrix8 corner_jacobian(const std::array<double, 8>& g, const TagFrame& frame,
                        const Corners& ideal_corners, const TagPattern& pattern) {
  const std::array<Point, 4> cells = border_corners(pattern);
  Matrix8 jacobian;
  for (int i = 0; i < 4; ++i) {
    const Point p = frame.to_frame(ideal_corners[i]);
    const double u = cells[i].x;
    const double v = cells[i].y;
    // The common factor 1 / (g6 x + g7 y + 1) of both sides is left out.
    Eigen::Matrix2d by_place;
    by_place << g[0] - u * g[6], g[1] - u * g[7], g[3] - v * g[6], g[4] - v * g[7];
    Eigen::Matrix<double, 2, 8> by_map;
    by_map << p.x, p.y, 1, 0, 0, 0, -u * p.x, -u * p.y,  //
        0, 0, 0, p.x, p.y, 1, -v * p.x, -v * p.y;
    jacobian.middleRows<2>(2 * i) = -frame.scale_px * (by_place.inverse() * by_map);
  }
  return jacobian;
}

Matrix8 lens_jacobian(const std::optional<Camera>& lens, const Corners& ideal_corners) {
  Matrix8 jacobian = Matrix8::Identity();
  if (!lens) return jacobian;
  constexpr double kStep_px = 1e-3;
  for (int i = 0; i < 4; ++i) {
    const Point p = ideal_corners[i];
    const Point dx =
        to_image_px(lens, p + Point{kStep_px, 0}) - to_image_px(lens, p - Point{kStep_px, 0});
    const Point dy =
        to_image_px(lens, p + Point{0, kStep_px}) - to_image_px(lens, p - Point{0, kStep_px});
    jacobian.block<2, 2>(2 * i, 2 * i) << dx.x, dy.x, dx.y, dy.y;
    jacobian.block<2, 2>(2 * i, 2 * i) /= 2 * kStep_px;
  }
  return jacobian;
}

}  // namespace tagmint::detect
