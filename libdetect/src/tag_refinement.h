#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <span>

#include "refine/refine_photometric.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/detector_options.h"
#include "tagmint/detect/image_view.h"
#include "work_share.h"

namespace tagmint::detect {

/// The photometric refinement of all tags of an image, whichever path found them.
class TagRefinement {
 public:
  explicit TagRefinement(const DetectorOptions& options);

  /// Gives each detection the corners that refine_photometric() finds.
  ///   stats   how many got some, and the time, are added
  void refine(ImageView full, std::span<Detection> detections, WorkShare& share,
              DetectStats& stats);

 private:
  /// What a thread needs for its share of the tags.
  struct Worker {
    PhotometricScratch photometric;
    DetectStats stats;
  };

  PhotometricOptions options_;
  tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace tagmint::detect
