#include <algorithm>

#include "evaluate/contender.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/version.h"
#include "tagmint/detect/detector.h"

namespace tagmint::evaluate {
namespace {

class TagmintContender : public Contender {
 public:
  TagmintContender(const Task& task, detect::DetectorOptions options)
      : detector_(
            {std::make_shared<const codec::Decoder>(
                task.family, codec::DecoderOptions{.max_errors = task.max_hamming, .ids = {}})},
            options) {}

  void detect(detect::ImageView image) override { detector_.detect(image, detections_, &stats_); }

  std::vector<FoundTag> found() const override {
    std::vector<FoundTag> tags;
    for (const detect::Detection& d : detections_) {
      tags.push_back({d.id, d.hamming, d.corners, d.corner_covariance});
    }
    return tags;
  }

  std::optional<std::int64_t> candidates() const override { return stats_.quads; }

 private:
  detect::Detector detector_;
  std::vector<detect::Detection> detections_;
  detect::DetectStats stats_;
};

detect::DetectorOptions options_of(const Task& task) {
  detect::DetectorOptions options;
  options.decimate = task.decimate;
  options.threads = task.threads;
  return options;
}

}  // namespace

int usual_max_hamming(const codec::Family& family) { return std::min(2, family.max_safe_errors()); }

std::vector<ContenderKind> own_contenders() {
  const std::string release = std::string("tagmint ") + std::string(codec::kVersion);
  return {{.name = "tagmint",
           .release = release,
           .style = 0,
           .make =
               [](const Task& task) {
                 return std::make_unique<TagmintContender>(task, options_of(task));
               }},
          {.name = "paper's method",
           .release = release + ", --algorithm paper, edges alone",
           .style = 1,
           .make = [](const Task& task) {
             detect::DetectorOptions options = options_of(task);
             options.algorithm = detect::Algorithm::Paper;
             options.refine_photometric = false;
             options.read_harder = false;
             options.contrast_by_noise = false;
             return std::make_unique<TagmintContender>(task, options);
           }}};
}

}  // namespace tagmint::evaluate
