#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/scene_file.h"

namespace tagmint::scene {
namespace {

/// "[a,b,...]" with enough digits that every number comes back as it is.
template <typename Numbers>
std::string list(const Numbers& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ","));
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string camera_json(const detect::Camera& camera) {
  return fmt::format(R"({{"fx":{},"fy":{},"cx":{},"cy":{},"distortion":[{},{},{},{},{}]}})",
                     camera.fx, camera.fy, camera.cx, camera.cy, camera.k1, camera.k2, camera.p1,
                     camera.p2, camera.k3);
}

std::string tag_json(const SceneTag& tag, const TagTruth& truth) {
  std::string json =
      fmt::format(R"({{"family":{},"id":{},"corners":[)", quoted(tag.family->name()), tag.id);
  for (std::size_t i = 0; i < 4; ++i) {
    fmt::format_to(std::back_inserter(json), "{}[{},{}]", i ? "," : "", truth.corners[i].x,
                   truth.corners[i].y);
  }
  json += "]";
  if (truth.homography) json += ",\"homography\":" + list(truth.homography->row_major());
  if (const auto* posed = std::get_if<PosedTag>(&tag.place)) {
    fmt::format_to(std::back_inserter(json), R"(,"edge_m":{},"pose":{{"R":{},"t":{}}})",
                   posed->edge_m, list(posed->pose.R), list(posed->pose.t));
  }
  if (tag.on_sheet) json += fmt::format(",\"board\":{}", tag.on_sheet->sheet);
  fmt::format_to(std::back_inserter(json), R"(,"visible":{:.6f},"visible_px":{:.3f}}})",
                 truth.visible, truth.visible_px);
  return json;
}

}  // namespace

std::string format_truth(const Scene& scene, std::span<const TagTruth> truth) {
  std::string json = fmt::format("{{\"width\":{},\"height\":{},\n \"camera\":{},\n \"tags\":[",
                                 scene.width, scene.height, camera_json(scene.camera));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    json += (i ? ",\n  " : "\n  ") + tag_json(scene.tags[i], truth[i]);
  }
  json += truth.empty() ? "]}\n" : "\n ]}\n";
  return json;
}

}  // namespace tagmint::scene
