#pragma once

#include <functional>

#include "cli/detect_plan.h"
#include "io/detections.h"
#include "tagmint/detect/detect_stats.h"

namespace tagmint::cli {

/// What was found in one image, and how.
struct DetectOutcome {
  io::ImageResult result;
  detect::DetectStats stats;
};

/// Reads every image of the plan, finds its tags and poses, and writes its overlay and debug
/// pictures. Several images share the threads, one has all of them; `take` gets the outcomes one at
/// a time in the order of the plan. An image that cannot be read is an outcome with an error.
///   threads   0 = all cores; the results do not depend on it, but for the times
/// Throws OutputError when a picture cannot be written, and what `take` throws.
void run_detection(const DetectPlan& plan, int threads,
                   const std::function<void(DetectOutcome&&)>& take);

/// Counters and stage times of an algorithm for people, one a line.
std::string stats_text(const detect::DetectStats& stats, detect::Algorithm algorithm);

}  // namespace tagmint::cli
