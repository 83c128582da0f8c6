#include "scene/scene_file.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "scene/board_reader.h"
#include "scene/json_reader.h"
#include "scene/picture_reader.h"
#include "scene/place_reader.h"
#include "scene/scene_families.h"
#include "tagmint/codec/errors.h"

namespace tagmint::scene {

using codec::InputError;
using detect::Corners;

namespace {

namespace fs = std::filesystem;

detect::Camera read_camera(const JsonValue& value, int width, int height) {
  value.require_keys({"fx", "fy", "cx", "cy", "distortion"});
  detect::Camera camera = default_camera(width, height);
  camera.fx = value.at("fx").number(1e-3, 1e9);
  camera.fy = value.has("fy") ? value.at("fy").number(1e-3, 1e9) : camera.fx;
  if (value.has("cx")) camera.cx = value.at("cx").number();
  if (value.has("cy")) camera.cy = value.at("cy").number();
  if (value.has("distortion")) {
    const auto d = value.at("distortion").numbers<5>();
    camera.k1 = d[0];
    camera.k2 = d[1];
    camera.p1 = d[2];
    camera.p2 = d[3];
    camera.k3 = d[4];
  }
  return camera;
}

SceneTag read_tag(const JsonValue& value, SceneFamilies& families) {
  value.require_keys({"family", "id", "edge_m", "pose", "position_m", "rotation_deg", "corners"});
  SceneTag tag;
  tag.family = families.get(value.at("family").text());
  tag.id = static_cast<codec::TagId>(value.at("id").whole(0, tag.family->size() - 1));
  if (!value.has("corners")) {
    tag.place = PosedTag{read_pose(value), value.at("edge_m").number(1e-9, 1e9)};
    return tag;
  }
  for (const char* other : {"edge_m", "pose", "position_m", "rotation_deg"}) {
    if (value.has(other)) {
      value.fail(std::string("has corners and ") + other, "place it one way or the other");
    }
  }
  Corners corners;
  const std::vector<JsonValue> given = value.at("corners").elements();
  if (given.size() != 4) {
    value.at("corners").fail("are not four", "give bottom-left, bottom-right, top-right, top-left");
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const auto xy = given[i].numbers<2>();
    corners[i] = {xy[0], xy[1]};
  }
  tag.place = corners;
  return tag;
}

Scene read_root(const JsonValue& root, const fs::path& folder) {
  root.require_keys({"width",
                     "height",
                     "camera",
                     "background",
                     "quiet_zone_cells",
                     "boards",
                     "tags",
                     "marks",
                     "black",
                     "white",
                     "shading",
                     "shadows",
                     "glare",
                     "vignetting",
                     "motion_blur",
                     "defocus_px",
                     "blur_px",
                     "electrons_per_level",
                     "gamma",
                     "noise",
                     "jpeg_quality",
                     "seed"});
  Scene scene;
  scene.width = static_cast<int>(root.at("width").whole(1, kMaxSide_px));
  scene.height = static_cast<int>(root.at("height").whole(1, kMaxSide_px));
  scene.camera = root.has("camera") ? read_camera(root.at("camera"), scene.width, scene.height)
                                    : default_camera(scene.width, scene.height);
  if (root.has("background")) scene.background = read_background(root.at("background"), folder);
  if (root.has("quiet_zone_cells")) {
    scene.quiet_zone_cells =
        static_cast<int>(root.at("quiet_zone_cells").whole(0, kMaxQuietZone_cells));
  }
  SceneFamilies families(folder);
  if (root.has("boards")) {
    for (const JsonValue& board : root.at("boards").elements()) add_board(board, families, scene);
  }
  // A scene of boards needs no others.
  if (root.has("tags") || !root.has("boards")) {
    for (const JsonValue& tag : root.at("tags").elements()) {
      scene.tags.push_back(read_tag(tag, families));
    }
  }
  if (root.has("marks")) scene.marks = read_marks(root.at("marks"));
  scene.effects = read_effects(root);
  if (root.has("seed")) {
    scene.seed = root.at("seed").whole(0, std::numeric_limits<std::uint64_t>::max());
  }
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view json, const std::string& source, const fs::path& folder) {
  const nlohmann::json parsed = parse_json(json, source);
  Scene scene = read_root(JsonValue(parsed, source), folder);
  try {
    check_scene(scene);
  } catch (const std::invalid_argument& fault) {
    throw InputError(fault.what(), source, "");
  }
  return scene;
}

Scene read_scene(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) {
    throw InputError("the scene file cannot be read", path.string(), "check the path");
  }
  return parse_scene(text, path.string(), path.parent_path());
}

}  // namespace tagmint::scene
