#pragma once

#include <vector>

#include "pipeline/s1_preprocess.h"
#include "pipeline/s2_threshold.h"
#include "pipeline/s3_segment.h"
#include "pipeline/s4_cluster.h"
#include "pipeline/s5_fit_quads.h"
#include "pipeline/stage_types.h"

namespace tagmint::testing {

/// Stages 1 to 5 on one picture, one after the other, as the detector runs them.
struct FrontHalf {
  detect::PreprocessOptions preprocess;
  detect::ThresholdOptions threshold;
  detect::ClusterOptions cluster;
  detect::QuadOptions quad;

  detect::PreprocessScratch preprocess_scratch;
  detect::ThresholdScratch threshold_scratch;
  detect::SegmentScratch segment_scratch;
  detect::ClusterScratch cluster_scratch;
  detect::QuadScratch quad_scratch;

  detect::Image working_image;
  detect::Image three_valued;
  detect::Components components;
  detect::Clusters clusters;
  detect::DetectStats stats;

  /// Quads in full-resolution pixels.
  std::vector<detect::Quad> quads(detect::ImageView full) {
    using namespace detect;
    stats = {};
    const ImageView working =
        detect::preprocess(full, preprocess, preprocess_scratch, working_image);
    detect::threshold(working, threshold, threshold_scratch, three_valued);
    segment(three_valued, segment_scratch, components);
    detect::cluster(components, cluster, cluster_scratch, clusters, stats);
    const WorkingScale scale{preprocess.decimate};
    std::vector<Quad> found;
    for (std::size_t i = 0; i < clusters.count(); ++i) {
      if (auto fit = fit_quad(clusters.cluster(i), working, quad, quad_scratch, stats)) {
        for (Point& corner : fit->corners) corner = scale.to_full(corner);
        found.push_back(*fit);
      }
    }
    return found;
  }
};

}  // namespace tagmint::testing
