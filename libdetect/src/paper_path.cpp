#include "paper_path.h"

#include <algorithm>

#include "stage_timer.h"
#include "tracker/t1_noise_floor.h"

namespace tagmint::detect {
namespace {

/// The noise of most of the picture may be texture, so it raises the contrast floor up to the lower
/// bound, gray levels; that of its calmest parts up to the higher one. Above, tags in good light
/// would be lost.
constexpr int kMostNoiseFloor = 36;
constexpr int kMostCalmNoiseFloor = 150;
/// Noise beyond what the floor can keep out, gray levels, is smoothed first: by a Gaussian of this
/// sigma, px, which leaves this share of it.
constexpr double kSmoothedNoise = 18;
constexpr double kSmoothingSigmaPx = 0.8;
constexpr double kNoiseLeft = 0.36;

void show_clusters(const Clusters& clusters, DebugSink& debug) {
  std::vector<Point> points;
  points.reserve(clusters.points.size());
  for (const BoundaryPoint& p : clusters.points) points.push_back({p.x, p.y});
  debug.clusters(points, clusters.begin);
}

}  // namespace

PaperPath::PaperPath(const DetectorOptions& o, const QuadKinds& kinds)
    : refine_edges_(o.refine_edges),
      contrast_by_noise_(o.contrast_by_noise),
      decimate_(o.decimate),
      preprocess_options_{.decimate = o.decimate, .blur_sigma_px = o.blur_sigma_px},
      threshold_options_{.min_contrast = o.min_contrast},
      cluster_options_{.min_points = o.min_cluster_points,
                       .min_component_pixels = smallest_ring_pixels(o.min_side_px / o.decimate),
                       .limits = OutlineLimits{.min_side_px = o.min_side_px / o.decimate,
                                               .normal_borders = kinds.normal_borders,
                                               .reversed_borders = kinds.reversed_borders}},
      quad_options_{.max_corner_candidates = o.max_corner_candidates,
                    .max_line_fit_mse_px2 = o.max_line_fit_mse_px2,
                    .critical_angle_deg = o.critical_angle_deg,
                    .min_side_px = o.min_side_px / o.decimate,
                    .normal_borders = kinds.normal_borders,
                    .reversed_borders = kinds.reversed_borders},
      refine_options_{.search_px = o.decimate + 1, .cells_at_border = kinds.cells_at_border} {}

/// Raises the contrast floor with the noise of `working`; returns it, or smoothed where that is not
/// enough.
ImageView PaperPath::answer_noise(ImageView working, ThresholdOptions& threshold_options) {
  double noise = estimate_noise(working);
  double calm_noise = estimate_calm_noise(working);
  if (calm_noise > kSmoothedNoise && preprocess_options_.blur_sigma_px == 0) {
    working = preprocess(working, {.decimate = 1, .blur_sigma_px = kSmoothingSigmaPx},
                         preprocess_scratch_, smoothed_);
    noise *= kNoiseLeft;
    calm_noise *= kNoiseLeft;
  }
  const int least = threshold_options.min_contrast;
  threshold_options.min_contrast =
      std::max(contrast_floor(noise, least, std::max(kMostNoiseFloor, least)),
               contrast_floor(calm_noise, least, std::max(kMostCalmNoiseFloor, least)));
  return working;
}

/// Stages 1 to 4; returns the working image.
ImageView PaperPath::find_clusters(ImageView full, DetectStats& stats, DebugSink* debug) {
  ImageView working;
  {
    const StageTimer timer(stats, Stage::Preprocess);
    working = preprocess(full, preprocess_options_, preprocess_scratch_, preprocessed_);
  }
  ThresholdOptions threshold_options = threshold_options_;
  if (contrast_by_noise_) {
    const StageTimer timer(stats, Stage::NoiseFloor);
    working = answer_noise(working, threshold_options);
  }
  if (debug) debug->preprocessed(working);
  {
    const StageTimer timer(stats, Stage::Threshold);
    threshold(working, threshold_options, threshold_scratch_, three_valued_);
  }
  if (debug) debug->threshold(three_valued_);
  {
    const StageTimer timer(stats, Stage::Segment);
    segment(three_valued_, segment_scratch_, components_);
  }
  stats.components += static_cast<std::int64_t>(components_.count());
  if (debug) {
    debug->components(component_of_each_pixel(components_), components_.width, components_.height);
  }
  {
    const StageTimer timer(stats, Stage::Cluster);
    ClusterOptions options = cluster_options_;
    if (debug) options.limits.reset();  // the picture shows all; stage 5 refuses the same ones
    cluster(components_, options, cluster_scratch_, clusters_, stats);
  }
  if (debug) show_clusters(clusters_, *debug);
  return working;
}

/// Stage 5; quads in full-resolution pixels, in the order of their clusters.
void PaperPath::fit_quads(ImageView working, WorkShare& share, DetectStats& stats) {
  const StageTimer timer(stats, Stage::FitQuads);
  fitted_.assign(clusters_.count(), std::nullopt);
  share.for_each_index(fitted_.size(), workers_, [&](std::size_t i, Worker& worker) {
    fitted_[i] = fit_quad(clusters_.cluster(i), working, quad_options_, worker.quads, worker.stats);
  });
  collect_stats(workers_, stats);
  const WorkingScale scale{decimate_};
  quads_.clear();
  for (const std::optional<Quad>& quad : fitted_) {
    if (!quad) continue;
    Quad& full = quads_.emplace_back(*quad);
    for (Point& corner : full.corners) corner = scale.to_full(corner);
  }
}

/// Stage 6.
void PaperPath::refine(ImageView full, WorkShare& share, DetectStats& stats) {
  const StageTimer timer(stats, Stage::RefineEdges);
  share.for_each_index(quads_.size(), workers_, [&](std::size_t i, Worker&) {
    quads_[i] = refine_edges(full, quads_[i], refine_options_);
  });
}

std::span<const Quad> PaperPath::find_quads(ImageView full, WorkShare& share, DetectStats& stats,
                                            DebugSink* debug) {
  const ImageView working = find_clusters(full, stats, debug);
  fit_quads(working, share, stats);
  if (debug) debug->quads(corners_of(quads_));
  if (refine_edges_) refine(full, share, stats);
  if (debug) debug->refined_quads(corners_of(quads_));
  return quads_;
}

}  // namespace tagmint::detect
