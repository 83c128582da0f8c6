#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/s1_preprocess.h"
#include "pipeline/stage_types.h"
#include "quad_kinds.h"
#include "tagmint/detect/debug_sink.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/detector_options.h"
#include "tagmint/detect/image.h"
#include "tagmint/detect/image_view.h"
#include "tracker/bit_plane.h"
#include "tracker/t2_bitmap.h"
#include "tracker/t4_track.h"
#include "tracker/t5_corners.h"
#include "tracker/t6_edges.h"
#include "work_share.h"

namespace tagmint::detect {

/// The fast way from pixels to refined quads: stages T1 to T6, with the scratch that they keep from
/// one image to the next. Works on bits instead of labels and follows shapes instead of collecting
/// boundary points (docs/detector.md).
///
/// The picture is cut into bands of kBandRows rows. Bands are independent of each other, and there
/// are as many of them however many threads share them, so the result depends on no thread.
class TrackerPath {
 public:
  TrackerPath(const DetectorOptions& options, const QuadKinds& kinds);

  /// As PaperPath::find_quads().
  std::span<const Quad> find_quads(ImageView full, WorkShare& share, DetectStats& stats,
                                   DebugSink* debug);

 private:
  /// What a thread needs for its share of the bands.
  struct Worker {
    BitmapScratch bitmap;
    std::vector<std::uint64_t> starts;
    VisitedBand visited;
    Shape shape;
    OutlineScratch corners;
    DetectStats stats;
  };

  void make_bitmaps(ImageView working, ContrastBand band, WorkShare& share, DetectStats& stats);
  void search(ImageView working, const BitPlane& plane, bool reversed, WorkShare& share,
              DetectStats& stats);
  void search_band(ImageView working, const BitPlane& plane, bool reversed, int band,
                   Worker& worker);
  void follow_start(ImageView working, const BitPlane& plane, bool reversed, int x, int y,
                    Worker& worker, std::vector<Quad>& found);

  DetectorOptions options_;
  QuadKinds kinds_;
  PreprocessOptions preprocess_options_;
  CornerOptions corner_options_;
  EdgeOptions edge_options_;

  PreprocessScratch preprocess_scratch_;
  Image preprocessed_;
  BitPlane black_;
  BitPlane white_;                             ///< only where a family has a reversed border
  std::vector<std::vector<Quad>> band_quads_;  ///< working px
  std::vector<Quad> quads_;
  tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace tagmint::detect
