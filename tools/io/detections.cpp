#include "io/detections.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

namespace tagmint::io {
namespace {

using detect::Point;
using detect::Pose;

constexpr int kDigits = 12;  // 1e-6 of a pixel in images of up to 10^5 pixels

constexpr int kFewDigits = 6;  // of what is an estimate itself

std::string number(double value) { return fmt::format("{:.{}g}", value, kDigits); }

/// The numbers, each with a comma before it but the first.
std::string numbers(std::span<const double> values, int digits = kDigits) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ',';
    text += fmt::format("{:.{}g}", value, digits);
  }
  return text;
}

/// Of covariances.
std::string rough_numbers(std::span<const double> values) { return numbers(values, kFewDigits); }

std::string json_text(const std::string& text) {
  // File names need not be UTF-8; JSON must be.
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_point(Point p) { return fmt::format("[{},{}]", number(p.x), number(p.y)); }

std::string json_pose(const Pose& pose) {
  std::string json = fmt::format(R"({{"R":[{}],"t":[{}],"error":{})", numbers(pose.R),
                                 numbers(pose.t), number(pose.error));
  if (pose.chi_squared) json += fmt::format(R"(,"chi_squared":{})", number(*pose.chi_squared));
  if (pose.covariance)
    json += fmt::format(R"(,"covariance":[{}])", rough_numbers(*pose.covariance));
  json += '}';
  return json;
}

/// What goes beyond libapriltag's fields; flags only where they are true.
std::string json_more(const FoundTag& tag) {
  const detect::Detection& d = tag.detection;
  std::string json = fmt::format(R"(,"margin_to_noise":{:.{}g},"log_odds":{:.{}g})",
                                 d.margin_to_noise, kFewDigits, d.log_odds, kFewDigits);
  if (d.inverted) json += R"(,"inverted":true)";
  if (d.mirrored) json += R"(,"mirrored":true)";
  if (d.corner_covariance) {
    json += fmt::format(R"(,"corner_covariance":[{}])", rough_numbers(*d.corner_covariance));
  }
  return json;
}

std::string json_tag(const FoundTag& tag) {
  const detect::Detection& d = tag.detection;
  std::string json = fmt::format(
      R"({{"family":{},"id":{},"hamming":{},"decision_margin":{},"center":{},"corners":[)",
      json_text(d.family->name()), d.id, d.hamming, number(d.decision_margin),
      json_point(d.center));
  for (std::size_t i = 0; i < 4; ++i) {
    if (i > 0) json += ',';
    json += json_point(d.corners[i]);
  }
  json += fmt::format(R"(],"homography":[{}])", numbers(d.homography.row_major()));
  if (tag.pose) {
    json += fmt::format(R"(,"pose":{})", json_pose(tag.pose->best));
    if (tag.pose->alternative) {
      json += fmt::format(R"(,"pose_alternative":{})", json_pose(*tag.pose->alternative));
    }
    if (tag.pose->alternative_probability) {
      json += fmt::format(R"(,"pose_alternative_probability":{:.{}g},"pose_ambiguous":{})",
                          *tag.pose->alternative_probability, kFewDigits, tag.pose->ambiguous());
    }
  }
  json += json_more(tag);
  json += '}';
  return json;
}

/// A field of CSV, in quotes where it holds something special.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  quoted += '"';
  return quoted;
}

constexpr int kPoseColumns = 13;

std::string csv_pose_header(const std::string& prefix) {
  std::string header;
  for (int i = 0; i < 9; ++i) header += fmt::format(",{}_r{}", prefix, i);
  header += fmt::format(",{0}_x,{0}_y,{0}_z,{0}_error", prefix);
  return header;
}

std::string csv_pose(const Pose* pose) {
  if (!pose) return std::string(kPoseColumns, ',');
  return fmt::format(",{},{},{}", numbers(pose->R), numbers(pose->t), number(pose->error));
}

/// Mean side of the border square as the image shows it, px.
double mean_side_px(const detect::Corners& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += length(corners[(i + 1) % 4] - corners[i]);
  return sum / 4;
}

}  // namespace

std::string format_jsonl(const ImageResult& result) {
  if (result.error) {
    return fmt::format("{{\"image\":{},\"error\":{}}}\n", json_text(result.image),
                       json_text(*result.error));
  }
  std::string line =
      fmt::format(R"({{"image":{},"width":{},"height":{},"elapsed_ms":{:.3f},)",
                  json_text(result.image), result.width, result.height, result.elapsed_ms);
  line += "\"detections\":[";
  for (std::size_t i = 0; i < result.tags.size(); ++i) {
    if (i > 0) line += ',';
    line += json_tag(result.tags[i]);
  }
  line += "]}\n";
  return line;
}

std::string csv_header(bool poses) {
  std::string header = "image,family,id,hamming,decision_margin,center_x,center_y";
  for (int i = 0; i < 4; ++i) header += fmt::format(",corner{0}_x,corner{0}_y", i);
  for (int i = 0; i < 9; ++i) header += fmt::format(",h{}", i);
  if (poses) header += csv_pose_header("pose") + csv_pose_header("alternative");
  header += '\n';
  return header;
}

std::string format_csv(const ImageResult& result, bool poses) {
  std::string lines;
  for (const FoundTag& tag : result.tags) {
    const detect::Detection& d = tag.detection;
    lines +=
        fmt::format("{},{},{},{},{},{},{}", csv_text(result.image), d.family->name(), d.id,
                    d.hamming, number(d.decision_margin), number(d.center.x), number(d.center.y));
    for (const Point corner : d.corners) {
      lines += fmt::format(",{},{}", number(corner.x), number(corner.y));
    }
    lines += fmt::format(",{}", numbers(d.homography.row_major()));
    if (poses) {
      const detect::PoseEstimate* pose = tag.pose ? &*tag.pose : nullptr;
      lines += csv_pose(pose ? &pose->best : nullptr);
      lines += csv_pose(pose && pose->alternative ? &*pose->alternative : nullptr);
    }
    lines += "\n";
  }
  return lines;
}

std::string format_text(const ImageResult& result) {
  if (result.error) return fmt::format("{}: {}\n", result.image, *result.error);
  std::string text = fmt::format("{}: {} x {} px, {} tag{}, {:.2f} ms\n", result.image,
                                 result.width, result.height, result.tags.size(),
                                 result.tags.size() == 1 ? "" : "s", result.elapsed_ms);
  if (result.tags.empty()) return text;
  std::size_t widest = 6;
  bool poses = false;
  for (const FoundTag& tag : result.tags) {
    widest = std::max(widest, tag.detection.family->name().size());
    poses = poses || tag.pose;
  }
  text += fmt::format("  {:<{}} {:>6} {:>6} {:>6} {:>9} {:>9} {:>7}", "family", widest, "id",
                      "errors", "margin", "center x", "center y", "side px");
  if (poses) text += fmt::format(" {:>9} {:>9} {:>9}", "x m", "y m", "z m");
  text += "\n";
  for (const FoundTag& tag : result.tags) {
    const detect::Detection& d = tag.detection;
    text += fmt::format("  {:<{}} {:>6} {:>6} {:>6.1f} {:>9.2f} {:>9.2f} {:>7.1f}",
                        d.family->name(), widest, d.id, d.hamming, d.decision_margin, d.center.x,
                        d.center.y, mean_side_px(d.corners));
    if (tag.pose) {
      const auto& t = tag.pose->best.t;
      text += fmt::format(" {:>9.4f} {:>9.4f} {:>9.4f}", t[0], t[1], t[2]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace tagmint::io
