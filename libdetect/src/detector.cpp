#include "tagmint/detect/detector.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "check_options.h"
#include "pipeline/s1_preprocess.h"
#include "pipeline/s2_threshold.h"
#include "pipeline/s3_segment.h"
#include "pipeline/s4_cluster.h"
#include "pipeline/s5_fit_quads.h"
#include "pipeline/s6_refine_edges.h"
#include "pipeline/s7_decode.h"
#include "pipeline/s8_reconcile.h"
#include "refine/refine_photometric.h"

namespace tagmint::detect {
namespace {

using Decoders = std::vector<std::shared_ptr<const codec::Decoder>>;

/// Threads to use: those asked for, 0 = all, but no more than there are cores, where oneTBB would
/// complain on the error stream.
int shared_by(int asked) {
  const int cores = tbb::info::default_concurrency();
  return asked == 0 ? cores : std::min(asked, cores);
}

/// Adds the time until its end to one stage.
class StageTimer {
 public:
  StageTimer(DetectStats& stats, Stage stage)
      : milliseconds_(stats.stage_ms[static_cast<std::size_t>(stage)]) {}
  ~StageTimer() {
    milliseconds_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& milliseconds_;
  Clock::time_point start_ = Clock::now();
};

/// What a thread needs for its share of the candidates.
struct Worker {
  QuadScratch quads;
  DecodeScratch decode;
  PhotometricScratch photometric;
  DetectStats stats;
};

void count(DecodeOutcome outcome, DetectStats& stats) {
  switch (outcome) {
    case DecodeOutcome::OutsideImage:
      ++stats.outside_image;
      break;
    case DecodeOutcome::NoContrast:
      ++stats.no_contrast;
      break;
    case DecodeOutcome::NoCodeword:
      ++stats.no_codeword;
      break;
    case DecodeOutcome::LowMargin:
      ++stats.low_margin;
      break;
    case DecodeOutcome::Decoded:
      break;
  }
}

std::vector<Corners> corners_of(std::span<const Quad> quads) {
  std::vector<Corners> corners;
  for (const Quad& quad : quads) corners.push_back(quad.corners);
  return corners;
}

void show_clusters(const Clusters& clusters, DebugSink& debug) {
  std::vector<Point> points;
  points.reserve(clusters.points.size());
  for (const BoundaryPoint& p : clusters.points) points.push_back({p.x, p.y});
  debug.clusters(points, clusters.begin);
}

}  // namespace

struct Detector::Impl {
  Decoders decoders;
  DetectorOptions options;
  int threads;
  tbb::task_arena arena;

  PreprocessOptions preprocess_options;
  ThresholdOptions threshold_options;
  ClusterOptions cluster_options;
  QuadOptions quad_options;
  RefineOptions refine_options;
  DecodeOptions decode_options;

  // Scratch, kept from one image to the next.
  PreprocessScratch preprocess_scratch;
  Image preprocessed;
  ThresholdScratch threshold_scratch;
  Image three_valued;
  SegmentScratch segment_scratch;
  Components components;
  ClusterScratch cluster_scratch;
  Clusters clusters;
  tbb::enumerable_thread_specific<Worker> workers;

  Impl(Decoders decoders, const DetectorOptions& options);
  std::vector<Detection> detect(ImageView full, DetectStats& stats, DebugSink* debug);

 private:
  ImageView find_clusters(ImageView full, DetectStats& stats, DebugSink* debug);
  std::vector<Quad> fit_quads(ImageView working, DetectStats& stats);
  void refine(ImageView full, std::vector<Quad>& quads, DetectStats& stats);
  std::vector<Detection> decode(ImageView full, std::span<const Quad> quads, DetectStats& stats);
  void refine_tags(ImageView full, std::vector<Detection>& detections, DetectStats& stats);
  void decode_one(ImageView full, const Quad& quad, Worker& worker, std::vector<Detection>& found);

  template <typename Function>
  void for_each_index(std::size_t size, DetectStats& stats, const Function& function);
};

Detector::Impl::Impl(Decoders given, const DetectorOptions& o)
    : decoders(std::move(given)),
      options(o),
      threads(shared_by(o.threads)),
      arena(threads),
      preprocess_options{.decimate = o.decimate, .blur_sigma_px = o.blur_sigma_px},
      threshold_options{.min_contrast = o.min_contrast},
      cluster_options{.min_points = o.min_cluster_points,
                      .min_component_pixels = smallest_ring_pixels(o.min_side_px / o.decimate)},
      quad_options{.max_corner_candidates = o.max_corner_candidates,
                   .max_line_fit_mse_px2 = o.max_line_fit_mse_px2,
                   .critical_angle_deg = o.critical_angle_deg,
                   .min_side_px = o.min_side_px / o.decimate,
                   .normal_borders = false,
                   .reversed_borders = false},
      refine_options{.search_px = o.decimate + 1, .cells_at_border = 0},
      decode_options{.sharpening = o.decode_sharpening,
                     .min_decision_margin = o.min_decision_margin} {
  for (const auto& decoder : decoders) {
    const codec::Layout& layout = decoder->family()->layout();
    (layout.reversed_border() ? quad_options.reversed_borders : quad_options.normal_borders) = true;
    refine_options.cells_at_border =
        std::max(refine_options.cells_at_border, layout.width_at_border());
  }
}

/// Calls function(i, worker) for all i in [0, size), shared between the threads, and adds what the
/// workers counted to `stats`. Each i writes to its own place, so the order does not matter.
template <typename Function>
void Detector::Impl::for_each_index(std::size_t size, DetectStats& stats,
                                    const Function& function) {
  if (threads == 1) {
    Worker& worker = workers.local();
    for (std::size_t i = 0; i < size; ++i) function(i, worker);
  } else {
    arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size), [&](const auto& range) {
        Worker& worker = workers.local();
        for (std::size_t i = range.begin(); i != range.end(); ++i) function(i, worker);
      });
    });
  }
  for (Worker& worker : workers) {
    stats += worker.stats;
    worker.stats = {};
  }
}

/// Stages 1 to 4; returns the working image.
ImageView Detector::Impl::find_clusters(ImageView full, DetectStats& stats, DebugSink* debug) {
  ImageView working;
  {
    const StageTimer timer(stats, Stage::Preprocess);
    working = preprocess(full, preprocess_options, preprocess_scratch, preprocessed);
  }
  if (debug) debug->preprocessed(working);
  {
    const StageTimer timer(stats, Stage::Threshold);
    threshold(working, threshold_options, threshold_scratch, three_valued);
  }
  if (debug) debug->threshold(three_valued);
  {
    const StageTimer timer(stats, Stage::Segment);
    segment(three_valued, segment_scratch, components);
  }
  stats.components += static_cast<std::int64_t>(components.count());
  if (debug) {
    debug->components(component_of_each_pixel(components), components.width, components.height);
  }
  {
    const StageTimer timer(stats, Stage::Cluster);
    cluster(components, cluster_options, cluster_scratch, clusters, stats);
  }
  if (debug) show_clusters(clusters, *debug);
  return working;
}

/// Stage 5; quads in full-resolution pixels, in the order of their clusters.
std::vector<Quad> Detector::Impl::fit_quads(ImageView working, DetectStats& stats) {
  const StageTimer timer(stats, Stage::FitQuads);
  std::vector<std::optional<Quad>> fitted(clusters.count());
  for_each_index(fitted.size(), stats, [&](std::size_t i, Worker& worker) {
    fitted[i] = fit_quad(clusters.cluster(i), working, quad_options, worker.quads, worker.stats);
  });
  const WorkingScale scale{options.decimate};
  std::vector<Quad> quads;
  for (const std::optional<Quad>& quad : fitted) {
    if (!quad) continue;
    Quad& full = quads.emplace_back(*quad);
    for (Point& corner : full.corners) corner = scale.to_full(corner);
  }
  return quads;
}

/// Stage 6.
void Detector::Impl::refine(ImageView full, std::vector<Quad>& quads, DetectStats& stats) {
  const StageTimer timer(stats, Stage::RefineEdges);
  for_each_index(quads.size(), stats, [&](std::size_t i, Worker&) {
    quads[i] = refine_edges(full, quads[i], refine_options);
  });
}

/// One quad against each family with its kind of border; counted once, by how far it came.
void Detector::Impl::decode_one(ImageView full, const Quad& quad, Worker& worker,
                                std::vector<Detection>& found) {
  DecodeOutcome farthest = DecodeOutcome::OutsideImage;
  for (const auto& decoder : decoders) {
    if (decoder->family()->layout().reversed_border() != quad.reversed_border) continue;
    DecodeResult result = decode_quad(full, quad, *decoder, decode_options, worker.decode);
    farthest = std::max(farthest, result.outcome);
    if (result.detection) found.push_back(std::move(*result.detection));
  }
  count(farthest, worker.stats);
}

/// Stage 7; candidates in the order of their quads.
std::vector<Detection> Detector::Impl::decode(ImageView full, std::span<const Quad> quads,
                                              DetectStats& stats) {
  const StageTimer timer(stats, Stage::Decode);
  std::vector<std::vector<Detection>> found(quads.size());
  for_each_index(quads.size(), stats, [&](std::size_t i, Worker& worker) {
    decode_one(full, quads[i], worker, found[i]);
  });
  std::vector<Detection> candidates;
  for (std::vector<Detection>& of_quad : found) {
    std::move(of_quad.begin(), of_quad.end(), std::back_inserter(candidates));
  }
  return candidates;
}

/// After stage 8.
void Detector::Impl::refine_tags(ImageView full, std::vector<Detection>& detections,
                                 DetectStats& stats) {
  const StageTimer timer(stats, Stage::RefineTags);
  const PhotometricOptions photometric{.lens = options.lens};
  for_each_index(detections.size(), stats, [&](std::size_t i, Worker& worker) {
    worker.stats.refined_tags +=
        refine_detection(full, detections[i], photometric, worker.photometric) ? 1 : 0;
  });
}

std::vector<Detection> Detector::Impl::detect(ImageView full, DetectStats& stats,
                                              DebugSink* debug) {
  const ImageView working = find_clusters(full, stats, debug);
  std::vector<Quad> quads = fit_quads(working, stats);
  if (debug) debug->quads(corners_of(quads));
  if (options.refine_edges) refine(full, quads, stats);
  if (debug) debug->refined_quads(corners_of(quads));
  std::vector<Detection> candidates = decode(full, quads, stats);
  std::vector<Detection> detections;
  {
    const StageTimer timer(stats, Stage::Reconcile);
    detections = reconcile(std::move(candidates), stats);
  }
  if (options.refine_photometric) refine_tags(full, detections, stats);
  if (debug) debug->detections(detections);
  return detections;
}

Detector::Detector(Decoders decoders, DetectorOptions options) {
  if (decoders.empty()) {
    throw std::invalid_argument("a detector needs at least one decoder; there is none");
  }
  if (std::find(decoders.begin(), decoders.end(), nullptr) != decoders.end()) {
    throw std::invalid_argument("a detector's decoder is null; each must be a Decoder");
  }
  check_options(options);
  impl_ = std::make_unique<Impl>(std::move(decoders), options);
}

Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

std::vector<Detection> Detector::detect(ImageView image, DetectStats* stats, DebugSink* debug) {
  if (!image.empty() && image.data == nullptr) {
    throw std::invalid_argument(fmt::format("an image of {} x {} pixels without data cannot be",
                                            image.width, image.height));
  }
  DetectStats counted;
  std::vector<Detection> detections;
  if (!image.empty()) detections = impl_->detect(image, counted, debug);
  if (stats) *stats = counted;
  return detections;
}

const DetectorOptions& Detector::options() const { return impl_->options; }

}  // namespace tagmint::detect
