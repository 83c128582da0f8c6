#include "scene/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <stdexcept>

#include "scene/projection.h"
#include "scene/tag_shape.h"

namespace tagmint::scene {
namespace {

using detect::Corners;
using detect::Point;

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

/// low <= value <= high, which NaN is not.
void require_range(std::string_view name, double value, double low, double high) {
  require(value >= low && value <= high,
          fmt::format("{} is {}; it must be from {} to {}", name, value, low, high));
}

/// Coordinates beyond this are no place in or near a picture, px.
constexpr double kFarthest_px = 1e6;

void require_finite(const std::string& name, std::span<const Point> points) {
  for (const Point p : points) {
    require(std::abs(p.x) <= kFarthest_px && std::abs(p.y) <= kFarthest_px,
            fmt::format("{} holds ({}, {}); coordinates must be from {} to {}", name, p.x, p.y,
                        -kFarthest_px, kFarthest_px));
  }
}

void check_marks(std::span<const Mark> marks) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const std::string name = fmt::format("marks[{}]", i);
    require(!marks[i].path.empty(), name + ": its path has no point; give one or more");
    require_finite(name + ".path", marks[i].path);
    require_range(name + ".width_px", marks[i].width_px, 0.01, 1e4);
    require_range(name + ".gray", marks[i].gray, 0, 255);
  }
}

struct CheckBackground {
  void operator()(const PlainBackground& plain) const {
    require_range("background.gray", plain.gray, 0, 255);
  }
  void operator()(const GradientBackground& gradient) const {
    require_range("background.gradient.from", gradient.from, 0, 255);
    require_range("background.gradient.to", gradient.to, 0, 255);
    require(std::isfinite(gradient.angle_deg), "background.gradient.angle_deg must be finite");
  }
  void operator()(const TextureBackground& texture) const {
    require_range("background.texture.gray", texture.gray, 0, 255);
    require_range("background.texture.amplitude", texture.amplitude, 0, 255);
    require_range("background.texture.scale_px", texture.scale_px, 1, 1e6);
  }
  void operator()(const ClutterBackground& clutter) const {
    require_range("background.clutter.shapes", clutter.shapes, 0, kMaxShapes);
    require_range("background.clutter.min_px", clutter.min_px, 0.1, 1e6);
    require_range("background.clutter.max_px", clutter.max_px, clutter.min_px, 1e6);
  }
  void operator()(const PhotoBackground& photo) const {
    require(photo.image.width() > 0 && photo.image.height() > 0,
            "background.image has no pixels; give a picture");
  }
};

void check_effects(const Effects& effects) {
  require_range("black", effects.black, 0, 255);
  require_range("white", effects.white, 0, 255);
  require(effects.black < effects.white,
          fmt::format("black is {} and white {}; black must be the darker one", effects.black,
                      effects.white));
  require(effects.shading.strength >= 0 && effects.shading.strength < 1,
          fmt::format("shading.strength is {}; it must be 0 or more and below 1",
                      effects.shading.strength));
  require(std::isfinite(effects.shading.angle_deg), "shading.angle_deg must be finite");
  for (std::size_t i = 0; i < effects.shadows.size(); ++i) {
    const std::string name = fmt::format("shadows[{}]", i);
    require(effects.shadows[i].polygon.size() >= 3,
            name + ": its polygon has fewer than three corners; give three or more");
    require_finite(name + ".polygon", effects.shadows[i].polygon);
    require_range(name + ".light", effects.shadows[i].light, 0, 1);
  }
  for (std::size_t i = 0; i < effects.glare.size(); ++i) {
    const std::string name = fmt::format("glare[{}]", i);
    require_finite(name + ".center", {&effects.glare[i].centre, 1});
    require_range(name + ".radius_px", effects.glare[i].radius_px, 0.1, 1e6);
    require_range(name + ".strength", effects.glare[i].strength, 0, 1e6);
  }
  require_range("vignetting", effects.vignetting, 0, 0.99);
  require_range("motion_blur.length_px", effects.motion_blur.length_px, 0, 1000);
  require(std::isfinite(effects.motion_blur.angle_deg), "motion_blur.angle_deg must be finite");
  require_range("defocus_px", effects.defocus_px, 0, 100);
  require_range("blur_px", effects.blur_sigma_px, 0, 1000);
  if (effects.electrons_per_level != 0) {
    require_range("electrons_per_level", effects.electrons_per_level, 0.001, 1e6);
  }
  require_range("gamma", effects.gamma, 0.1, 10);
  require_range("noise", effects.noise_sigma, 0, 255);
  if (effects.jpeg_quality != 0) require_range("jpeg_quality", effects.jpeg_quality, 1, 100);
}

void check_rotation(const std::array<double, 9>& R, const std::string& name) {
  constexpr double kTolerance = 1e-6;
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double product = 0;
      for (std::size_t k = 0; k < 3; ++k) product += R[i * 3 + k] * R[j * 3 + k];
      require(std::abs(product - (i == j ? 1 : 0)) < kTolerance,
              name + ": R is no rotation; its rows must be of length 1 and at right angles");
    }
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    determinant += R[i] * (R[3 + j] * R[6 + k] - R[3 + k] * R[6 + j]);
  }
  require(determinant > 0, name + ": R is a reflection; its determinant must be 1");
}

void check_posed(const PosedTag& tag, const std::string& name) {
  require(tag.edge_m > 0 && std::isfinite(tag.edge_m),
          fmt::format("{}: edge_m is {}; it must be above 0", name, tag.edge_m));
  check_rotation(tag.pose.R, name);
  const auto& R = tag.pose.R;
  const auto& t = tag.pose.t;
  require(std::isfinite(t[0]) && std::isfinite(t[1]) && std::isfinite(t[2]),
          name + ": its position must be finite");
  require(t[2] > 0, fmt::format("{}: its middle lies behind the camera (z = {} m); z must be above "
                                "0",
                                name, t[2]));
  require(R[2] * t[0] + R[5] * t[1] + R[8] * t[2] > 0,
          name + ": it faces away from the camera; turn it by less than 90 degrees");
}

void check_corners(const Corners& corners, const std::string& name) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % 4];
    const Point c = corners[(i + 2) % 4];
    // Not written as >= 0, so that NaN is refused as well.
    require(cross(b - a, c - b) < 0,
            name +
                ": its corners are not a convex quad, counter-clockwise as seen from the "
                "bottom-left one; give bottom-left, bottom-right, top-right, top-left");
  }
}

/// The distortion model turns back beyond its fold: paper there would be drawn a second time.
void check_fold(const TagPlace& place, std::span<const Rectangle> paper, double fold,
                const std::string& name) {
  if (!std::holds_alternative<PosedTag>(place) || !std::isfinite(fold)) return;
  detect::Camera straight;
  straight.fx = straight.fy = 1;
  const TagProjection normalised(place, straight);
  for (const Rectangle& run : paper) {
    for (const Point p : run) {
      require(normalised.depth(p) > kNearest && length(normalised.project(p)) < fold,
              fmt::format("{}: it reaches beyond {:.3f} focal lengths from the middle, where the "
                          "camera's distortion folds back; move it inwards",
                          name, fold));
    }
  }
}

void check_tag(const SceneTag& tag, const Scene& scene, double fold, const std::string& name) {
  require(tag.family != nullptr, name + " has no family");
  require(tag.id < tag.family->size(),
          fmt::format("{}: id {} is not in {}, which has ids 0 to {}", name, tag.id,
                      tag.family->name(), tag.family->size() - 1));
  if (const auto* posed = std::get_if<PosedTag>(&tag.place)) {
    check_posed(*posed, name);
  } else {
    check_corners(std::get<Corners>(tag.place), name);
  }
  if (tag.on_sheet) {
    require(tag.on_sheet->sheet < scene.sheets.size(), name + " is on a sheet that is not there");
  } else {
    const codec::Codeword codeword = tag.family->codeword(tag.id);
    check_fold(tag.place, tag_shape(tag.layout(), codeword, scene.quiet_zone_cells).paper, fold,
               name);
  }
}

void check_sheet(const Sheet& sheet, const Scene& scene, double fold, const std::string& name) {
  // Sheets are placed as a tag whose edge is two metres: half an edge is its unit.
  const PosedTag posed{.pose = sheet.pose, .edge_m = 2};
  check_posed(posed, name);
  require(sheet.first_tag <= scene.tags.size(), name + " begins with a tag that is not there");
  const SheetBox& paper = sheet.paper;
  require(paper.width > 0 && paper.height > 0,
          name + ": its paper must be wider and higher than 0");
  const double right = paper.left + paper.width, bottom = paper.top + paper.height;
  const Rectangle corners = {
      {paper.left, paper.top}, {right, paper.top}, {right, bottom}, {paper.left, bottom}};
  check_fold(posed, {&corners, 1}, fold, name);
}

}  // namespace

detect::Camera default_camera(int width, int height) {
  detect::Camera camera;
  camera.fx = camera.fy = width;
  camera.cx = width / 2.0;
  camera.cy = height / 2.0;
  return camera;
}

void check_scene(const Scene& scene) {
  require_range("width", scene.width, 1, kMaxSide_px);
  require_range("height", scene.height, 1, kMaxSide_px);
  require_range("quiet_zone_cells", scene.quiet_zone_cells, 0, kMaxQuietZone_cells);
  detect::check_camera(scene.camera);
  std::visit(CheckBackground{}, scene.background);
  check_effects(scene.effects);
  check_marks(scene.marks);
  const double fold = fold_radius(scene.camera);
  for (std::size_t i = 0; i < scene.sheets.size(); ++i) {
    check_sheet(scene.sheets[i], scene, fold, fmt::format("boards[{}]", i));
    require(i == 0 || scene.sheets[i - 1].first_tag <= scene.sheets[i].first_tag,
            "boards are not in the order of their first tags");
  }
  for (std::size_t i = 0; i < scene.tags.size(); ++i) {
    check_tag(scene.tags[i], scene, fold, fmt::format("tags[{}]", i));
  }
}

}  // namespace tagmint::scene
