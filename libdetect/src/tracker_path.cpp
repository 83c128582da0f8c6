#include "tracker_path.h"

#include <algorithm>
#include <bit>

#include "kernels/start_kernels.h"
#include "stage_timer.h"
#include "tracker/t1_noise_floor.h"

namespace tagmint::detect {
namespace {

/// Rows of a band: enough that the rows which bands share cost little, few enough that a band stays
/// in the nearest cache. A multiple of kTile.
constexpr int kBandRows = 64;
/// Bounds of the contrast floor, gray levels: the lower one is the option's; above the upper one
/// tags in good light would be lost.
constexpr int kMostFloor = 36;

int bands_of(ImageView image) { return (image.height + kBandRows - 1) / kBandRows; }

/// A picture of the bits for people.
void show_threshold(const BitPlane& black, const BitPlane& white, DebugSink& debug) {
  Image picture(black.width(), black.height(), kUnknown);
  for (int y = 0; y < black.height(); ++y) {
    for (int x = 0; x < black.width(); ++x) {
      if (black.at(x, y)) picture.at(x, y) = kBlack;
      if (white.at(x, y)) picture.at(x, y) = kWhite;
    }
  }
  debug.threshold(picture);
}

}  // namespace

TrackerPath::TrackerPath(const DetectorOptions& o, const QuadKinds& kinds)
    : options_(o),
      kinds_(kinds),
      preprocess_options_{.decimate = o.decimate, .blur_sigma_px = o.blur_sigma_px},
      corner_options_{.min_side_px = o.min_side_px / o.decimate},
      edge_options_{.min_side_px = o.min_side_px,
                    .cells_at_border = static_cast<double>(kinds.cells_at_border)} {}

/// Stage T2, a band at a time.
void TrackerPath::make_bitmaps(ImageView working, ContrastBand band, WorkShare& share,
                               DetectStats& stats) {
  const StageTimer timer(stats, Stage::Bitmap);
  black_.resize(working.width, working.height);
  if (kinds_.reversed_borders) white_.resize(working.width, working.height);
  share.for_each_index(
      static_cast<std::size_t>(bands_of(working)), workers_, [&](std::size_t i, Worker& worker) {
        const int first = static_cast<int>(i) * kBandRows;
        threshold_rows(working, first, std::min(first + kBandRows, working.height), band,
                       worker.bitmap, black_, kinds_.reversed_borders ? &white_ : nullptr);
      });
}

/// Stages T4 to T6 for one start.
void TrackerPath::follow_start(ImageView working, const BitPlane& plane, bool reversed, int x,
                               int y, Worker& worker, std::vector<Quad>& found) {
  DetectStats& stats = worker.stats;
  ++stats.starts;
  switch (track_shape(plane, x, y, worker.visited, worker.shape)) {
    case TrackOutcome::Covered:
      ++stats.starts_covered;
      return;
    case TrackOutcome::Visited:
      ++stats.starts_visited;
      return;
    case TrackOutcome::NotConvex:
      ++stats.starts_not_convex;
      return;
    case TrackOutcome::Done:
      break;
  }
  ++stats.shapes;
  const CornerResult result = find_corners(worker.shape, corner_options_, worker.corners);
  if (!result.corners) {
    switch (result.refused) {
      case CornerOutcome::TooSmall:
        ++stats.shapes_too_small;
        return;
      case CornerOutcome::NoCorners:
        ++stats.no_corners;
        return;
      case CornerOutcome::WrongArea:
      case CornerOutcome::NotStraight:
        ++stats.bad_shape;
        return;
    }
  }
  const Quad quad{*result.corners, reversed};
  if (const std::optional<Quad> fitted = fit_edges(working, quad, edge_options_)) {
    found.push_back(*fitted);
  } else {
    ++stats.bad_fit;
  }
}

/// Stage T3 for one band, and all that follows from its starts.
void TrackerPath::search_band(ImageView working, const BitPlane& plane, bool reversed, int band,
                              Worker& worker) {
  const int first = band * kBandRows;
  const int rows = std::min(kBandRows, working.height - first);
  const auto words = static_cast<std::size_t>((plane.words() + kBitVectorWords - 1) /
                                              kBitVectorWords * kBitVectorWords);
  worker.starts.resize(words * kBandRows);
  const auto height = static_cast<std::size_t>(working.height);
  if (worker.shape.left.size() < height) {
    worker.shape.left.resize(height);
    worker.shape.right.resize(height);
  }
  {
    const StageTimer timer(worker.stats, Stage::Starts);
    find_starts({plane.row(first), static_cast<std::ptrdiff_t>(plane.stride())}, rows,
                plane.words(), worker.starts.data(), static_cast<std::ptrdiff_t>(words));
  }
  const StageTimer timer(worker.stats, Stage::Track);
  worker.visited.reset(first, first + rows, working.width);
  std::vector<Quad>& found = band_quads_[static_cast<std::size_t>(band)];
  for (std::size_t i = 0; i < words * static_cast<std::size_t>(rows); ++i) {
    for (std::uint64_t left = worker.starts[i]; left != 0; left &= left - 1) {
      const int x = static_cast<int>(i % words) * 64 + std::countr_zero(left);
      follow_start(working, plane, reversed, x, first + static_cast<int>(i / words), worker, found);
    }
  }
}

void TrackerPath::search(ImageView working, const BitPlane& plane, bool reversed, WorkShare& share,
                         DetectStats& stats) {
  share.for_each_index(static_cast<std::size_t>(bands_of(working)), workers_,
                       [&](std::size_t i, Worker& worker) {
                         search_band(working, plane, reversed, static_cast<int>(i), worker);
                       });
  collect_stats(workers_, stats);
}

std::span<const Quad> TrackerPath::find_quads(ImageView full, WorkShare& share, DetectStats& stats,
                                              DebugSink* debug) {
  ImageView working;
  {
    const StageTimer timer(stats, Stage::Preprocess);
    working = preprocess(full, preprocess_options_, preprocess_scratch_, preprocessed_);
  }
  if (debug) debug->preprocessed(working);
  ContrastBand band;
  {
    const StageTimer timer(stats, Stage::NoiseFloor);
    int floor = options_.min_contrast;
    if (options_.contrast_by_noise) {
      floor = contrast_floor(estimate_noise(working), floor, std::max(kMostFloor, floor));
    }
    band.floor = static_cast<std::uint8_t>(floor);
  }
  make_bitmaps(working, band, share, stats);
  (void)show_threshold;
  const auto bands = static_cast<std::size_t>(bands_of(working));
  if (band_quads_.size() < bands) band_quads_.resize(bands);
  for (std::vector<Quad>& quads : band_quads_) quads.clear();
  if (kinds_.normal_borders) search(working, black_, false, share, stats);
  if (kinds_.reversed_borders) search(working, white_, true, share, stats);
  quads_.clear();
  const WorkingScale scale{options_.decimate};
  for (const std::vector<Quad>& quads : band_quads_) {
    for (Quad quad : quads) {
      for (Point& corner : quad.corners) corner = scale.to_full(corner);
      quads_.push_back(quad);
    }
  }
  if (debug) debug->quads(corners_of(quads_));
  if (debug) debug->refined_quads(corners_of(quads_));
  return quads_;
}

}  // namespace tagmint::detect
