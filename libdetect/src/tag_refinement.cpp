#include "tag_refinement.h"

#include "stage_timer.h"
#include "tracker/t1_noise_floor.h"

namespace tagmint::detect {

TagRefinement::TagRefinement(const DetectorOptions& options) : options_{.lens = options.lens} {}

void TagRefinement::refine(ImageView full, std::span<Detection> detections, WorkShare& share,
                           DetectStats& stats) {
  const StageTimer timer(stats, Stage::RefineTags);
  if (detections.empty()) return;
  const double noise = estimate_noise(full);
  options_.noise = noise > 0 ? std::optional(noise) : std::nullopt;  // 0: it could not be judged
  share.for_each_index(detections.size(), workers_, [&](std::size_t i, Worker& worker) {
    worker.stats.refined_tags +=
        refine_detection(full, detections[i], options_, worker.photometric) ? 1 : 0;
  });
  collect_stats(workers_, stats);
}

}  // namespace tagmint::detect
