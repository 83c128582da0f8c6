#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/stage_types.h"
#include "quad_kinds.h"
#include "tagmint/detect/debug_sink.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/image_view.h"
#include "tracker/bit_plane.h"
#include "tracker/known_quads.h"
#include "tracker/t2_bitmap.h"
#include "tracker/t4_track.h"
#include "tracker/t5_corners.h"
#include "tracker/t6_edges.h"
#include "work_share.h"

namespace tagmint::detect {

/// Stages T2 to T6 on one picture, with the scratch that they keep from one picture to the next.
///
/// The picture is cut into bands of kBandRows rows. Bands are independent of each other, and there
/// are as many of them however many threads share them, so the result depends on no thread.
class QuadSearch {
 public:
  struct Options {
    double min_side_px = 4;  ///< quads with a smaller mean side are refused, px of the picture
    bool fit_edges = true;   ///< false: corners stay as the bitmap has them
    /// Quads of the picture that need not be found again.
    const KnownQuads* known = nullptr;
  };

  explicit QuadSearch(const QuadKinds& kinds) : kinds_(kinds) {}

  /// Adds the picture's quads to `quads`, in its pixels, band by band.
  ///   contrast   which tiles are looked at, and what is black in them
  ///   stats      counts and times are added
  ///   debug      takes the bitmap and the outlines of the shapes followed, or null
  void run(ImageView image, ContrastRule contrast, const Options& options, WorkShare& share,
           DetectStats& stats, DebugSink* debug, std::vector<Quad>& quads);

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
  /// What came of a band.
  struct Band {
    std::vector<Quad> quads;
    std::vector<Point> outline_points;  ///< of all shapes, for debug pictures
    std::vector<std::size_t> outline_ends;
  };
  /// One search over the bands: for black shapes, or for white ones.
  struct Task {
    ImageView image;
    const BitPlane& plane;
    bool reversed;
    Options options;
    bool keep_outlines;
  };

  void make_bitmaps(ImageView image, ContrastRule contrast, WorkShare& share, DetectStats& stats);
  void search(const Task& task, WorkShare& share, DetectStats& stats);
  void search_band(const Task& task, int index, Worker& worker);
  void follow_starts(const Task& task, int first, int rows, std::size_t words, Worker& worker,
                     Band& band);
  void follow_start(const Task& task, int x, int y, Worker& worker, Band& band);
  void fit_band(const Task& task, std::size_t first, Worker& worker, Band& band);
  void show_outlines(DebugSink& debug) const;

  QuadKinds kinds_;
  BitPlane black_;
  BitPlane white_;  ///< only where a family has a reversed border
  std::vector<Band> bands_;
  tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace tagmint::detect
