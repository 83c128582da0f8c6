// Prints how many tags are found and how true their corners are, by the tag's side in pixels,
// beside libapriltag on the same pictures: tag36h11, frontal, turned at random, blur 0.5 px,
// noise 5.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}

#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/detect/detector.h"

namespace tagmint {
namespace {

constexpr int kTags = 192;
constexpr int kColumns = 16;

/// Tags in a grid; tag i has id i.
struct Scene {
  detect::Image image;
  std::vector<detect::Corners> truth;
};

Scene scene_of_side(double side_px) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  const double pitch = 1.6 * side_px + 12;
  testing::FixedRandom random(7);
  testing::Canvas canvas(static_cast<int>(kColumns * pitch),
                         static_cast<int>(kTags / kColumns * pitch), 130);
  Scene scene;
  for (int i = 0; i < kTags; ++i) {
    const detect::Point centre{(i % kColumns + 0.5) * pitch + random.real(-0.5, 0.5),
                               (i / kColumns + 0.5) * pitch + random.real(-0.5, 0.5)};
    const auto map = testing::square_at(centre, side_px, random.real(0, 2 * std::numbers::pi));
    testing::paint_tag(canvas, *family, static_cast<codec::TagId>(i), map);
    scene.truth.push_back(testing::corners_of(map));
  }
  testing::blur(canvas, 0.5);
  scene.image = testing::to_gray(canvas, 5, random);
  return scene;
}

using Found = std::vector<std::pair<int, detect::Corners>>;

Found detect_ours(const detect::Image& image, const detect::DetectorOptions& options) {
  detect::Detector detector(
      {std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"))}, options);
  Found found;
  for (const detect::Detection& d : detector.detect(image)) found.emplace_back(d.id, d.corners);
  return found;
}

Found detect_theirs(detect::Image& image) {
  apriltag_family_t* family = tag36h11_create();
  apriltag_detector_t* detector = apriltag_detector_create();
  apriltag_detector_add_family_bits(detector, family, 2);
  detector->quad_decimate = 1;
  image_u8_t view = {image.width(), image.height(), image.width(), image.row(0)};
  zarray_t* detections = apriltag_detector_detect(detector, &view);
  Found found;
  for (int i = 0; i < zarray_size(detections); ++i) {
    apriltag_detection_t* d = nullptr;
    zarray_get(detections, i, &d);
    detect::Corners corners;
    for (int k = 0; k < 4; ++k) corners[k] = {d->p[k][0], d->p[k][1]};
    found.emplace_back(d->id, corners);
  }
  apriltag_detections_destroy(detections);
  apriltag_detector_destroy(detector);
  tag36h11_destroy(family);
  return found;
}

/// "recall / median corner error / mean error of the side", over tags found near their place.
std::string judge(const Found& found, const Scene& scene, double side_px) {
  std::vector<double> errors;
  double side_sum = 0;
  int tags = 0;
  for (const auto& [id, corners] : found) {
    if (id >= kTags || length(corners[0] - scene.truth[id][0]) > side_px) continue;
    ++tags;
    side_sum += std::sqrt(std::abs(signed_area(corners)));
    for (int k = 0; k < 4; ++k) errors.push_back(length(corners[k] - scene.truth[id][k]));
  }
  if (tags == 0) return "0 %";
  std::sort(errors.begin(), errors.end());
  return fmt::format("{:.0f} % / {:.3f} px / {:+.2f} %", 100.0 * tags / kTags,
                     errors[errors.size() / 2], 100 * (side_sum / tags / side_px - 1));
}

}  // namespace
}  // namespace tagmint

int main() {
  using tagmint::detect::Algorithm;
  fmt::print(
      "| side | tracker | paper | paper, edges alone | libapriltag |\n|---|---|---|---|---|\n");
  for (const double side : {8, 9, 10, 12, 15, 18, 24, 32, 80}) {
    tagmint::Scene scene = tagmint::scene_of_side(side);
    const auto ours = [&](const tagmint::detect::DetectorOptions& options) {
      return tagmint::judge(tagmint::detect_ours(scene.image, options), scene, side);
    };
    const std::string tracker = ours({.algorithm = Algorithm::Tracker});
    const std::string paper = ours({.algorithm = Algorithm::Paper});
    const std::string edges = ours({.algorithm = Algorithm::Paper, .refine_photometric = false});
    const std::string theirs = tagmint::judge(tagmint::detect_theirs(scene.image), scene, side);
    fmt::print("| {} px | {} | {} | {} | {} |\n", side, tracker, paper, edges, theirs);
  }
}
