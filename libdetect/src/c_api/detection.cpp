#include <algorithm>
#include <cstdlib>

#include "c_api/boundary.h"
#include "c_api/objects.h"
#include "tagmint/detect/pose.h"

namespace {

using namespace tagmint;
using c_api::guarded;
using c_api::required;

detect::DetectorOptions detector_options(const tagmint_detector_options& given) {
  if (given.struct_size != sizeof(tagmint_detector_options)) {
    throw std::invalid_argument(
        "the options have not been through tagmint_detector_options_init(); call it first");
  }
  detect::DetectorOptions options;
  options.decimate = given.decimate;
  options.blur_sigma_px = given.blur_sigma_px;
  options.min_decision_margin = given.min_decision_margin;
  options.refine_edges = given.refine_edges != 0;
  options.threads = given.threads;
  return options;
}

detect::ImageView view_of(const tagmint_image& image) {
  if (image.width < 0 || image.height < 0) {
    throw std::invalid_argument(fmt::format(
        "an image of {} x {} pixels cannot be; sides are 0 or more", image.width, image.height));
  }
  const bool empty = image.width == 0 || image.height == 0;
  if (!empty && image.data == nullptr) {
    throw std::invalid_argument("the image has no data; give its first pixel");
  }
  if (!empty && image.height > 1 && std::abs(image.stride) < image.width) {
    throw std::invalid_argument(
        fmt::format("rows of {} pixels cannot be {} bytes apart; the stride is at least the width",
                    image.width, image.stride));
  }
  return {image.data, image.width, image.height, image.stride};
}

void copy_point(detect::Point from, double* to) {
  to[0] = from.x;
  to[1] = from.y;
}

tagmint_detection plain(const detect::Detection& tag) {
  tagmint_detection result{};
  result.family = tag.family->name().c_str();
  result.id = tag.id;
  result.hamming = tag.hamming;
  result.decision_margin = tag.decision_margin;
  copy_point(tag.center, result.center);
  for (std::size_t i = 0; i < tag.corners.size(); ++i) {
    copy_point(tag.corners[i], result.corners[i]);
  }
  std::copy_n(tag.homography.row_major().begin(), 9, result.homography);
  return result;
}

tagmint_pose plain(const detect::Pose& pose) {
  tagmint_pose result{};
  std::copy_n(pose.R.begin(), 9, result.R);
  std::copy_n(pose.t.begin(), 3, result.t);
  result.error = pose.error;
  return result;
}

/// Holds the detector for one call.
class Turn {
 public:
  explicit Turn(tagmint_detector& detector)
      : detector_(detector), taken_(!detector.busy.test_and_set(std::memory_order_acquire)) {}
  ~Turn() {
    if (taken_) detector_.busy.clear(std::memory_order_release);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  bool taken() const { return taken_; }

 private:
  tagmint_detector& detector_;
  bool taken_;
};

}  // namespace

extern "C" {

void tagmint_detector_options_init(tagmint_detector_options* options) {
  if (options == nullptr) return;
  const detect::DetectorOptions defaults;
  *options = {.struct_size = sizeof(tagmint_detector_options),
              .decimate = defaults.decimate,
              .blur_sigma_px = defaults.blur_sigma_px,
              .min_decision_margin = defaults.min_decision_margin,
              .refine_edges = defaults.refine_edges,
              .threads = defaults.threads};
}

tagmint_status tagmint_detector_create(const tagmint_decoder* const* decoders, size_t count,
                                       const tagmint_detector_options* options,
                                       tagmint_detector** detector) {
  return guarded([&] {
    required(decoders, "decoders");
    required(detector, "detector");
    std::vector<std::shared_ptr<const codec::Decoder>> list;
    for (std::size_t i = 0; i < count; ++i) {
      list.push_back(required(decoders[i], "decoders[i]").decoder);
    }
    detect::Detector made(std::move(list),
                          options ? detector_options(*options) : detect::DetectorOptions{});
    *detector = new tagmint_detector{std::move(made)};
    return TAGMINT_OK;
  });
}

void tagmint_detector_free(tagmint_detector* detector) { delete detector; }

tagmint_status tagmint_detector_detect(tagmint_detector* detector, const tagmint_image* image,
                                       tagmint_detections** detections) {
  return guarded([&] {
    tagmint_detector& d = required(detector, "detector");
    const detect::ImageView view = view_of(required(image, "image"));
    required(detections, "detections");
    const Turn turn(d);
    if (!turn.taken()) {
      return c_api::fail(TAGMINT_ERROR_BUSY,
                         "another thread is using the detector; make one for each thread");
    }
    auto found = std::make_unique<tagmint_detections>();
    for (const detect::Detection& tag : d.detector.detect(view)) {
      found->tags.push_back(plain(tag));
      found->families.push_back(tag.family);
    }
    *detections = found.release();
    return TAGMINT_OK;
  });
}

void tagmint_detections_free(tagmint_detections* detections) { delete detections; }

size_t tagmint_detections_count(const tagmint_detections* detections) {
  return detections ? detections->tags.size() : 0;
}

const tagmint_detection* tagmint_detections_data(const tagmint_detections* detections) {
  return detections && !detections->tags.empty() ? detections->tags.data() : nullptr;
}

tagmint_status tagmint_estimate_pose(const double (*corners)[2], const tagmint_camera* camera,
                                     double edge_m, tagmint_pose_estimate* pose) {
  return guarded([&] {
    required(corners, "corners");
    const tagmint_camera& c = required(camera, "camera");
    required(pose, "pose");
    detect::Corners points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {corners[i][0], corners[i][1]};
    const detect::Camera lens{.fx = c.fx,
                              .fy = c.fy,
                              .cx = c.cx,
                              .cy = c.cy,
                              .k1 = c.k1,
                              .k2 = c.k2,
                              .p1 = c.p1,
                              .p2 = c.p2,
                              .k3 = c.k3};
    const auto estimate = detect::estimate_pose(points, lens, edge_m);
    if (!estimate) return TAGMINT_NOTHING;
    pose->best = plain(estimate->best);
    pose->has_alternative = estimate->alternative.has_value();
    pose->alternative = plain(estimate->alternative.value_or(detect::Pose{}));
    return TAGMINT_OK;
  });
}

}  // extern "C"
