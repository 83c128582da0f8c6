#pragma once

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
#include "tracker/quad_search.h"
#include "work_share.h"

namespace tagmint::detect {

/// The fast way from pixels to refined quads: stages T1 to T6, with the scratch that they keep from
/// one image to the next. Works on bits instead of labels and follows shapes instead of collecting
/// boundary points (docs/detector.md).
///
/// The noise of the picture sets the least contrast that is looked at. What is fainter is looked
/// for once more in a picture half as large, which has half the noise.
///
/// Memory: for a picture of n pixels, n / 8 bytes of black bits, as many of white ones where a
/// family has a reversed border, a quarter of that and n / 4 bytes for the half-size picture, and a
/// few rows: at most 0.6 bytes a pixel.
class TrackerPath {
 public:
  TrackerPath(const DetectorOptions& options, const QuadKinds& kinds);

  /// As PaperPath::find_quads().
  std::span<const Quad> find_quads(ImageView full, WorkShare& share, DetectStats& stats,
                                   DebugSink* debug);

 private:
  void search_at(ImageView image, double scale, ContrastRule contrast, QuadSearch& search,
                 const KnownQuads* known, WorkShare& share, DetectStats& stats, DebugSink* debug);
  ImageView halved(ImageView image, WorkShare& share, DetectStats& stats);

  DetectorOptions options_;
  PreprocessOptions preprocess_options_;
  PreprocessScratch preprocess_scratch_;
  Image preprocessed_;
  Image halved_;
  QuadSearch whole_search_;
  QuadSearch half_search_;
  std::vector<Quad> trusted_;  ///< quads that need not be looked for at half the size
  KnownQuads known_;
  std::vector<Quad> quads_;
};

}  // namespace tagmint::detect
