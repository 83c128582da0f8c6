#include <memory>

#include "detector/contender.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector.h"

namespace tagmint::bench {
namespace {

class TagmintContender : public Contender {
 public:
  TagmintContender(const Task& task, const detect::DetectorOptions& options)
      : detector_(decoders(task), options) {}

  void detect(detect::ImageView image) override { detections_ = detector_.detect(image); }
  std::vector<FoundTag> found() const override {
    std::vector<FoundTag> tags;
    for (const detect::Detection& d : detections_) {
      tags.push_back({d.family->name(), d.id, d.corners});
    }
    return tags;
  }

 private:
  static std::vector<std::shared_ptr<const codec::Decoder>> decoders(const Task& task) {
    std::vector<std::shared_ptr<const codec::Decoder>> made;
    for (const std::string& name : task.families) {
      made.push_back(std::make_shared<const codec::Decoder>(codec::find_family(name)));
    }
    return made;
  }

  detect::Detector detector_;
  std::vector<detect::Detection> detections_;
};

/// Settings that are measured, beside the decimation.
enum Variant { kTracker, kPaper, kPaperEdges };

std::unique_ptr<Contender> make_tagmint(const Task& task, double decimate, int variant) {
  detect::DetectorOptions options;
  options.algorithm = variant == kTracker ? detect::Algorithm::Tracker : detect::Algorithm::Paper;
  options.refine_photometric = variant != kPaperEdges;
  options.decimate = decimate;
  options.threads = task.threads;
  return std::make_unique<TagmintContender>(task, options);
}

}  // namespace

std::vector<ContenderKind> tagmint_contenders() {
  return {{.name = "tagmint tracker", .make = make_tagmint, .variant = kTracker},
          {.name = "tagmint paper", .make = make_tagmint, .variant = kPaper},
          {.name = "tagmint paper, edges alone", .make = make_tagmint, .variant = kPaperEdges},
          {.name = "tagmint paper, decimate 2",
           .make = make_tagmint,
           .decimate = 2,
           .variant = kPaper}};
}

}  // namespace tagmint::bench
