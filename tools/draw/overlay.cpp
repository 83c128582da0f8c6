#include "draw/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/picture_canvas.h"

namespace tagmint::draw {
namespace {

using detect::Point;
using io::FoundTag;

constexpr Colour kGreen{0.1, 0.9, 0.25};
constexpr Colour kRed{1.0, 0.2, 0.15};
constexpr Colour kBlue{0.25, 0.5, 1.0};

/// Square root of the area: the size that lines and letters follow.
double size_px(const detect::Corners& corners) {
  return std::sqrt(std::abs(detect::signed_area(corners)));
}

bool several_families(std::span<const FoundTag> tags) {
  return std::any_of(tags.begin(), tags.end(), [&](const FoundTag& tag) {
    return tag.detection.family != tags.front().detection.family;
  });
}

/// Pixel of a point in the tag's frame, metres; nothing behind the camera.
std::optional<Point> pixel_of(const std::array<double, 3>& p, const detect::Pose& pose,
                              const detect::Camera& camera) {
  std::array<double, 3> q = pose.t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) q[i] += pose.R[i * 3 + k] * p[k];
  }
  if (q[2] <= 0) return std::nullopt;
  return camera.to_pixel({q[0] / q[2], q[1] / q[2]});
}

void draw_axes(const detect::Pose& pose, const AxesSetting& setting, double width_px,
               PictureCanvas& canvas) {
  const auto origin = pixel_of({0, 0, 0}, pose, setting.camera);
  if (!origin) return;
  const std::array<Colour, 3> colours = {kRed, kGreen, kBlue};
  for (std::size_t axis = 3; axis-- > 0;) {
    std::array<double, 3> tip{};
    tip[axis] = setting.edge_m / 2;
    const auto end = pixel_of(tip, pose, setting.camera);
    if (!end) continue;
    canvas.set_colour(colours[axis]);
    canvas.line(*origin, *end, width_px);
  }
}

}  // namespace

io::RgbImage draw_overlay(const detect::ImageView& picture, std::span<const FoundTag> tags,
                          const std::optional<AxesSetting>& axes) {
  PictureCanvas canvas(picture);
  const bool name_families = several_families(tags);
  for (const FoundTag& tag : tags) {
    const detect::Corners& corners = tag.detection.corners;
    const double size = size_px(corners);
    const double width = std::clamp(size / 30, 1.0, 4.0);
    canvas.set_colour(kGreen);
    canvas.outline(corners, width);
    canvas.set_colour(kRed);
    canvas.disc(corners[0], 1.6 * width);
    if (axes && tag.pose) draw_axes(tag.pose->best, *axes, 1.3 * width, canvas);
  }
  // Labels last: no line crosses them.
  for (const FoundTag& tag : tags) {
    const detect::Detection& d = tag.detection;
    const double height = std::clamp(0.2 * size_px(d.corners), 9.0, 40.0);
    // With axes the label stands aside of them, towards the first corner.
    const Point place = axes && tag.pose ? d.center + 0.5 * (d.corners[0] - d.center) : d.center;
    const std::string text =
        name_families ? fmt::format("{} {}", d.family->name(), d.id) : fmt::format("{}", d.id);
    canvas.label(place, name_families ? std::max(9.0, 0.5 * height) : height, text);
  }
  return canvas.picture();
}

}  // namespace tagmint::draw
