#include "support/camera_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/fixed_random.h"
#include "support/paint_tags.h"

namespace tagmint::test {
namespace {

using detect::Point;

constexpr double kRadian = std::numbers::pi / 180.0;
/// Distance of the camera in widths of the image plane's view: a field of about 50 degrees.
constexpr double kDistance = 1.1;

double gray_at(const detect::Image& picture, Point p, double surround, const CameraView& view) {
  const int x = static_cast<int>(std::floor(p.x));
  const int y = static_cast<int>(std::floor(p.y));
  if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) return surround;
  return view.black + (view.white - view.black) * picture.at(x, y) / 255.0;
}

}  // namespace

detect::Homography picture_to_image(const detect::Image& picture, const CameraView& view) {
  const double scale = view.fill * std::min(double(view.width) / picture.width(),
                                            double(view.height) / picture.height());
  const double distance = kDistance * view.width;
  const double c = std::cos(view.axis_deg * kRadian);
  const double s = std::sin(view.axis_deg * kRadian);
  const auto seen = [&](Point p) -> Point {
    const Point q = scale * Point{p.x - picture.width() / 2.0, p.y - picture.height() / 2.0};
    const double roll = view.roll_deg * kRadian;
    const Point r = {std::cos(roll) * q.x - std::sin(roll) * q.y,
                     std::sin(roll) * q.x + std::cos(roll) * q.y};
    // Along the axis nothing changes; across it the plane leans away.
    const double along = c * r.x + s * r.y;
    const double across = -s * r.x + c * r.y;
    const double leaning = across * std::cos(view.tilt_deg * kRadian);
    const double depth = distance + across * std::sin(view.tilt_deg * kRadian);
    const Point on_plane = {c * along - s * leaning, s * along + c * leaning};
    return Point{view.width / 2.0, view.height / 2.0} + (distance / depth) * on_plane;
  };
  const double w = picture.width();
  const double h = picture.height();
  const std::array<Point, 4> from = {{{0, h}, {w, h}, {w, 0}, {0, 0}}};
  const auto map = detect::Homography::from_points(
      from, {seen(from[0]), seen(from[1]), seen(from[2]), seen(from[3])});
  if (!map) throw std::logic_error("the view is edge-on");
  return *map;
}

detect::Image seen_by_camera(const detect::Image& picture, const CameraView& view,
                             std::uint64_t seed) {
  const auto image_to_picture = picture_to_image(picture, view).inverse();
  if (!image_to_picture) throw std::logic_error("the view is edge-on");
  testing::Canvas canvas(view.width, view.height, 0);
  constexpr int kPlaces = 3;  // a side
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      double sum = 0;
      for (int i = 0; i < kPlaces * kPlaces; ++i) {
        const Point p = {x + (i % kPlaces + 0.5) / kPlaces, y + (i / kPlaces + 0.5) / kPlaces};
        sum += gray_at(picture, image_to_picture->project(p), view.surround, view);
      }
      canvas.at(x, y) = static_cast<float>(sum / (kPlaces * kPlaces));
    }
  }
  testing::blur(canvas, view.blur_sigma_px);
  testing::FixedRandom random(seed);
  return testing::to_gray(canvas, view.noise_sigma, random);
}

}  // namespace tagmint::test
