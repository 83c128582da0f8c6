#include "tracker/quad_search.h"

#include <algorithm>
#include <bit>

#include "kernels/start_kernels.h"
#include "stage_timer.h"
#include "tagmint/detect/image.h"

namespace tagmint::detect {
namespace {

/// Rows of a band: enough that the rows which bands share cost little, few enough that a band stays
/// in the nearest cache. A multiple of kTile.
constexpr int kBandRows = 64;

int bands_of(ImageView image) { return (image.height + kBandRows - 1) / kBandRows; }

/// The bitmap for people. Without a plane of its own, white is what is not black.
void show_bitmap(const BitPlane& black, const BitPlane* white, DebugSink& debug) {
  Image picture(black.width(), black.height(), white ? kUnknown : kWhite);
  for (int y = 0; y < black.height(); ++y) {
    for (int x = 0; x < black.width(); ++x) {
      if (black.at(x, y)) picture.at(x, y) = kBlack;
      if (white && white->at(x, y)) picture.at(x, y) = kWhite;
    }
  }
  debug.threshold(picture);
}

/// Down the right side and up the left one.
void keep_outline(const Shape& shape, std::vector<Point>& points, std::vector<std::size_t>& ends) {
  for (int i = 0; i < shape.height; ++i)
    points.push_back({shape.right[i] + 1.0, shape.top + i + 0.5});
  for (int i = shape.height - 1; i >= 0; --i) {
    points.push_back({static_cast<double>(shape.left[i]), shape.top + i + 0.5});
  }
  ends.push_back(points.size());
}

void count(TrackOutcome outcome, DetectStats& stats) {
  switch (outcome) {
    case TrackOutcome::Covered:
      ++stats.starts_covered;
      break;
    case TrackOutcome::Visited:
      ++stats.starts_visited;
      break;
    case TrackOutcome::NotConvex:
      ++stats.starts_not_convex;
      break;
    case TrackOutcome::Done:
      ++stats.shapes;
      break;
  }
}

void count(CornerOutcome outcome, DetectStats& stats) {
  switch (outcome) {
    case CornerOutcome::TooSmall:
      ++stats.shapes_too_small;
      break;
    case CornerOutcome::NoCorners:
      ++stats.no_corners;
      break;
    case CornerOutcome::WrongArea:
    case CornerOutcome::NotStraight:
      ++stats.bad_shape;
      break;
  }
}

}  // namespace

/// Stage T2, a band at a time.
void QuadSearch::make_bitmaps(ImageView image, ContrastRule contrast, WorkShare& share,
                              DetectStats& stats) {
  const StageTimer timer(stats, Stage::Bitmap);
  black_.resize(image.width, image.height);
  if (kinds_.reversed_borders) white_.resize(image.width, image.height);
  share.for_each_index(
      static_cast<std::size_t>(bands_of(image)), workers_, [&](std::size_t i, Worker& worker) {
        const int first = static_cast<int>(i) * kBandRows;
        threshold_rows(image, first, std::min(first + kBandRows, image.height), contrast,
                       worker.bitmap, black_, kinds_.reversed_borders ? &white_ : nullptr);
      });
}

/// Stages T4 and T5 for one start.
void QuadSearch::follow_start(const Task& task, int x, int y, Worker& worker, Band& band) {
  DetectStats& stats = worker.stats;
  ++stats.starts;
  const TrackOutcome outcome = track_shape(task.plane, x, y, worker.visited, worker.shape);
  count(outcome, stats);
  if (outcome != TrackOutcome::Done) return;
  if (task.keep_outlines) keep_outline(worker.shape, band.outline_points, band.outline_ends);
  const CornerResult result =
      find_corners(worker.shape, {.min_side_px = task.options.min_side_px}, worker.corners);
  if (!result.corners) {
    count(result.refused, stats);
    return;
  }
  const Quad quad{*result.corners, task.reversed};
  if (task.options.known && task.options.known->holds(quad)) {
    ++stats.quads_known;
    return;
  }
  band.quads.push_back(quad);
}

/// Stage T6 for the quads of a band from `first` on.
void QuadSearch::fit_band(const Task& task, std::size_t first, Worker& worker, Band& band) {
  const StageTimer timer(worker.stats, Stage::FitEdges);
  const EdgeOptions options{.min_side_px = task.options.min_side_px};
  std::size_t kept = first;
  for (std::size_t i = first; i < band.quads.size(); ++i) {
    if (const std::optional<Quad> fitted = fit_edges(task.image, band.quads[i], options)) {
      band.quads[kept++] = *fitted;
    } else {
      ++worker.stats.bad_fit;
    }
  }
  band.quads.resize(kept);
}

/// Stage T3 for one band, and all that follows from its starts.
void QuadSearch::search_band(const Task& task, int index, Worker& worker) {
  const BitPlane& plane = task.plane;
  const int first = index * kBandRows;
  const int rows = std::min(kBandRows, plane.height() - first);
  const auto words = static_cast<std::size_t>((plane.words() + kBitVectorWords - 1) /
                                              kBitVectorWords * kBitVectorWords);
  worker.starts.resize(words * kBandRows);
  const auto height = static_cast<std::size_t>(plane.height());
  if (worker.shape.left.size() < height) {
    worker.shape.left.resize(height);
    worker.shape.right.resize(height);
  }
  {
    const StageTimer timer(worker.stats, Stage::Starts);
    find_starts({plane.row(first), static_cast<std::ptrdiff_t>(plane.stride())}, rows,
                plane.words(), worker.starts.data(), static_cast<std::ptrdiff_t>(words));
  }
  Band& band = bands_[static_cast<std::size_t>(index)];
  const std::size_t known = band.quads.size();
  follow_starts(task, first, rows, words, worker, band);
  if (task.options.fit_edges) fit_band(task, known, worker, band);
}

/// All starts of a band, row by row.
void QuadSearch::follow_starts(const Task& task, int first, int rows, std::size_t words,
                               Worker& worker, Band& band) {
  const StageTimer timer(worker.stats, Stage::Track);
  worker.visited.reset(first, first + rows, task.plane.width());
  for (int y = 0; y < rows; ++y) {
    const std::uint64_t* const starts = worker.starts.data() + static_cast<std::size_t>(y) * words;
    for (int word = 0; word < task.plane.words(); ++word) {
      for (std::uint64_t left = starts[word]; left != 0; left &= left - 1) {
        follow_start(task, word * 64 + std::countr_zero(left), first + y, worker, band);
      }
    }
  }
}

void QuadSearch::search(const Task& task, WorkShare& share, DetectStats& stats) {
  share.for_each_index(
      static_cast<std::size_t>(bands_of(task.image)), workers_,
      [&](std::size_t i, Worker& worker) { search_band(task, static_cast<int>(i), worker); });
  collect_stats(workers_, stats);
}

void QuadSearch::show_outlines(DebugSink& debug) const {
  std::vector<Point> points;
  std::vector<std::size_t> begin = {0};
  for (const Band& band : bands_) {
    const std::size_t base = points.size();
    points.insert(points.end(), band.outline_points.begin(), band.outline_points.end());
    for (const std::size_t end : band.outline_ends) begin.push_back(base + end);
  }
  debug.clusters(points, begin);
}

void QuadSearch::run(ImageView image, ContrastRule contrast, const Options& options,
                     WorkShare& share, DetectStats& stats, DebugSink* debug,
                     std::vector<Quad>& quads) {
  make_bitmaps(image, contrast, share, stats);
  if (debug) show_bitmap(black_, kinds_.reversed_borders ? &white_ : nullptr, *debug);
  const auto bands = static_cast<std::size_t>(bands_of(image));
  if (bands_.size() < bands) bands_.resize(bands);
  for (Band& band : bands_) {
    band.quads.clear();
    band.outline_points.clear();
    band.outline_ends.clear();
  }
  if (kinds_.normal_borders)
    search({image, black_, false, options, debug != nullptr}, share, stats);
  if (kinds_.reversed_borders)
    search({image, white_, true, options, debug != nullptr}, share, stats);
  if (debug) show_outlines(*debug);
  for (std::size_t i = 0; i < bands; ++i) {
    quads.insert(quads.end(), bands_[i].quads.begin(), bands_[i].quads.end());
  }
}

}  // namespace tagmint::detect
