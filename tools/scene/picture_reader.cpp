#include "scene/picture_reader.h"

#include "io/images.h"

namespace tagmint::scene {
namespace {

namespace fs = std::filesystem;

detect::Point read_point(const JsonValue& value) {
  const auto xy = value.numbers<2>();
  return {xy[0], xy[1]};
}

std::vector<detect::Point> read_points(const JsonValue& value) {
  std::vector<detect::Point> points;
  for (const JsonValue& point : value.elements()) points.push_back(read_point(point));
  return points;
}

}  // namespace

Background read_background(const JsonValue& value, const fs::path& folder) {
  value.require_keys({"gray", "gradient", "texture", "clutter", "image"});
  const std::string kind = value.only_key();
  const JsonValue details = value.at(kind);
  if (kind == "gray") return PlainBackground{details.number(0, 255)};
  if (kind == "gradient") {
    details.require_keys({"from", "to", "angle_deg"});
    GradientBackground gradient;
    if (details.has("from")) gradient.from = details.at("from").number(0, 255);
    if (details.has("to")) gradient.to = details.at("to").number(0, 255);
    if (details.has("angle_deg")) gradient.angle_deg = details.at("angle_deg").number();
    return gradient;
  }
  if (kind == "texture") {
    details.require_keys({"gray", "amplitude", "scale_px"});
    TextureBackground texture;
    if (details.has("gray")) texture.gray = details.at("gray").number(0, 255);
    if (details.has("amplitude")) texture.amplitude = details.at("amplitude").number(0, 255);
    if (details.has("scale_px")) texture.scale_px = details.at("scale_px").number(1, 1e6);
    return texture;
  }
  if (kind == "clutter") {
    details.require_keys({"shapes", "min_px", "max_px"});
    ClutterBackground clutter;
    if (details.has("shapes")) {
      clutter.shapes = static_cast<int>(details.at("shapes").whole(0, kMaxShapes));
    }
    if (details.has("min_px")) clutter.min_px = details.at("min_px").number(0.1, 1e6);
    if (details.has("max_px")) clutter.max_px = details.at("max_px").number(0.1, 1e6);
    return clutter;
  }
  const std::string path = details.text();
  return PhotoBackground{path, io::read_gray_image((folder / path).string())};
}

std::vector<Mark> read_marks(const JsonValue& value) {
  std::vector<Mark> marks;
  for (const JsonValue& given : value.elements()) {
    given.require_keys({"path", "width_px", "gray"});
    Mark& mark = marks.emplace_back();
    mark.path = read_points(given.at("path"));
    if (given.has("width_px")) mark.width_px = given.at("width_px").number(0.01, 1e4);
    if (given.has("gray")) mark.gray = given.at("gray").number(0, 255);
  }
  return marks;
}

Effects read_effects(const JsonValue& root) {
  Effects effects;
  if (root.has("black")) effects.black = root.at("black").number(0, 255);
  if (root.has("white")) effects.white = root.at("white").number(0, 255);
  if (root.has("defocus_px")) effects.defocus_px = root.at("defocus_px").number(0, 100);
  if (root.has("blur_px")) effects.blur_sigma_px = root.at("blur_px").number(0, 1000);
  if (root.has("electrons_per_level")) {
    effects.electrons_per_level = root.at("electrons_per_level").number(0.001, 1e6);
  }
  if (root.has("jpeg_quality")) {
    effects.jpeg_quality = static_cast<int>(root.at("jpeg_quality").whole(1, 100));
  }
  if (root.has("noise")) effects.noise_sigma = root.at("noise").number(0, 255);
  if (root.has("shading")) {
    const JsonValue shading = root.at("shading");
    shading.require_keys({"strength", "angle_deg"});
    effects.shading.strength = shading.at("strength").number(0, 1);
    if (shading.has("angle_deg")) effects.shading.angle_deg = shading.at("angle_deg").number();
  }
  if (root.has("shadows")) {
    for (const JsonValue& shadow : root.at("shadows").elements()) {
      shadow.require_keys({"polygon", "light"});
      Shadow& added = effects.shadows.emplace_back();
      added.polygon = read_points(shadow.at("polygon"));
      if (shadow.has("light")) added.light = shadow.at("light").number(0, 1);
    }
  }
  if (root.has("glare")) {
    for (const JsonValue& spot : root.at("glare").elements()) {
      spot.require_keys({"center", "radius_px", "strength"});
      Glare& added = effects.glare.emplace_back();
      added.centre = read_point(spot.at("center"));
      if (spot.has("radius_px")) added.radius_px = spot.at("radius_px").number(0.1, 1e6);
      if (spot.has("strength")) added.strength = spot.at("strength").number(0, 1e6);
    }
  }
  if (root.has("vignetting")) effects.vignetting = root.at("vignetting").number(0, 0.99);
  if (root.has("motion_blur")) {
    const JsonValue motion = root.at("motion_blur");
    motion.require_keys({"length_px", "angle_deg"});
    effects.motion_blur.length_px = motion.at("length_px").number(0, 1000);
    if (motion.has("angle_deg")) effects.motion_blur.angle_deg = motion.at("angle_deg").number();
  }
  if (root.has("gamma")) effects.gamma = root.at("gamma").number(0.1, 10);
  return effects;
}

}  // namespace tagmint::scene
