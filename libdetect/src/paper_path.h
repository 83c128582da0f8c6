#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <optional>
#include <span>
#include <vector>

#include "pipeline/s1_preprocess.h"
#include "pipeline/s2_threshold.h"
#include "pipeline/s3_segment.h"
#include "pipeline/s4_cluster.h"
#include "pipeline/s5_fit_quads.h"
#include "pipeline/s6_refine_edges.h"
#include "pipeline/stage_types.h"
#include "quad_kinds.h"
#include "tagmint/detect/debug_sink.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/detector_options.h"
#include "tagmint/detect/image.h"
#include "tagmint/detect/image_view.h"
#include "work_share.h"

namespace tagmint::detect {

/// The way of the paper from pixels to refined quads [WangOlson2016]: stages 1 to 6, with the
/// scratch that they keep from one image to the next.
class PaperPath {
 public:
  PaperPath(const DetectorOptions& options, const QuadKinds& kinds);

  /// Quads in full-resolution pixels, valid until the next call.
  ///   share   the threads that fit and refine them
  ///   stats   counts and times of these stages are added
  ///   debug   takes the pictures of these stages, or null
  std::span<const Quad> find_quads(ImageView full, WorkShare& share, DetectStats& stats,
                                   DebugSink* debug);

 private:
  /// What a thread needs for its share of the clusters.
  struct Worker {
    QuadScratch quads;
    DetectStats stats;
  };

  ImageView answer_noise(ImageView working, ThresholdOptions& threshold_options);
  ImageView find_clusters(ImageView full, DetectStats& stats, DebugSink* debug);
  void fit_quads(ImageView working, WorkShare& share, DetectStats& stats);
  void refine(ImageView full, WorkShare& share, DetectStats& stats);

  bool refine_edges_;
  bool contrast_by_noise_;
  double decimate_;
  PreprocessOptions preprocess_options_;
  ThresholdOptions threshold_options_;
  ClusterOptions cluster_options_;
  QuadOptions quad_options_;
  RefineOptions refine_options_;

  PreprocessScratch preprocess_scratch_;
  Image preprocessed_;
  Image smoothed_;
  ThresholdScratch threshold_scratch_;
  Image three_valued_;
  SegmentScratch segment_scratch_;
  Components components_;
  ClusterScratch cluster_scratch_;
  Clusters clusters_;
  std::vector<std::optional<Quad>> fitted_;
  std::vector<Quad> quads_;
  tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace tagmint::detect
