#include "cli/detect_run.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "draw/debug_writer.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/pose.h"

namespace tagmint::cli {
namespace {

using detect::Detector;
using detect::DetectStats;
using Clock = std::chrono::steady_clock;

Detector make_detector(const DetectPlan& plan, int threads) {
  detect::DetectorOptions options = plan.detector;
  options.threads = threads;
  return Detector(plan.decoders, options);
}

DetectOutcome detect_one(const DetectPlan& plan, const ImageTask& task, Detector& detector) {
  DetectOutcome outcome;
  io::ImageResult& result = outcome.result;
  result.image = task.image;
  detect::Image image;
  try {
    image = io::read_gray_image(task.image);
  } catch (const codec::InputError& fault) {
    result.error = fault.what();
    return outcome;
  }
  result.width = image.width();
  result.height = image.height();
  std::optional<draw::DebugWriter> debug;
  if (!task.debug_folder.empty()) debug.emplace(task.debug_folder, image.view());
  const Clock::time_point start = Clock::now();
  std::vector<detect::Detection> found =
      detector.detect(image, &outcome.stats, debug ? &*debug : nullptr);
  result.elapsed_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  if (debug) {  // without the time that its pictures took
    const auto& stages = outcome.stats.stage_ms;
    result.elapsed_ms = std::accumulate(stages.begin(), stages.end(), 0.0);
  }
  for (detect::Detection& detection : found) {
    io::FoundTag tag{std::move(detection), {}};
    if (plan.poses) {
      tag.pose = detect::estimate_pose(tag.detection.corners, plan.poses->camera,
                                       plan.poses->edge_m, tag.detection.corner_covariance);
    }
    result.tags.push_back(std::move(tag));
  }
  if (!task.overlay.empty()) {
    // A folder that cannot be made is told by the write.
    std::error_code ignored;
    std::filesystem::create_directories(task.overlay.parent_path(), ignored);
    io::write_png(task.overlay, draw::draw_overlay(image, result.tags, plan.poses));
  }
  return outcome;
}

void run_in_parallel(const DetectPlan& plan, int threads,
                     const std::function<void(DetectOutcome&&)>& take) {
  tbb::enumerable_thread_specific<Detector> detectors([&] { return make_detector(plan, 1); });
  // A few more images under way than threads, so that a slow one does not stop the others.
  const std::size_t under_way = 2 * static_cast<std::size_t>(threads) + 2;
  std::size_t next = 0;
  const auto give = [&](tbb::flow_control& control) -> std::size_t {
    if (next == plan.tasks.size()) control.stop();
    return next == plan.tasks.size() ? next : next++;
  };
  const auto work = [&](std::size_t task) {
    return detect_one(plan, plan.tasks[task], detectors.local());
  };
  tbb::task_arena(threads).execute([&] {
    tbb::parallel_pipeline(
        under_way,
        tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, give) &
            tbb::make_filter<std::size_t, DetectOutcome>(tbb::filter_mode::parallel, work) &
            tbb::make_filter<DetectOutcome, void>(
                tbb::filter_mode::serial_in_order,
                [&](DetectOutcome outcome) { take(std::move(outcome)); }));
  });
}

}  // namespace

void run_detection(const DetectPlan& plan, int threads,
                   const std::function<void(DetectOutcome&&)>& take) {
  const int cores = tbb::info::default_concurrency();
  const int used = threads > 0 ? std::min(threads, cores) : cores;
  if (plan.tasks.size() > 1 && used > 1) {
    run_in_parallel(plan, used, take);
    return;
  }
  Detector detector = make_detector(plan, used);
  for (const ImageTask& task : plan.tasks) take(detect_one(plan, task, detector));
}

namespace {

struct Counter {
  const char* name;
  std::int64_t DetectStats::*count;
};

constexpr Counter kPaperCounters[] = {
    {"components", &DetectStats::components},
    {"boundary points", &DetectStats::boundary_points},
    {"clusters", &DetectStats::clusters},
    {"  too large", &DetectStats::clusters_too_large},
    {"  open", &DetectStats::clusters_open},
    {"  too small", &DetectStats::clusters_too_small},
    {"  wrong border colour", &DetectStats::wrong_border_colour},
};
constexpr Counter kTrackerCounters[] = {
    {"starts", &DetectStats::starts},
    {"  covered", &DetectStats::starts_covered},
    {"  seen before", &DetectStats::starts_visited},
    {"  not convex", &DetectStats::starts_not_convex},
    {"shapes", &DetectStats::shapes},
    {"  too small", &DetectStats::shapes_too_small},
    {"  found before", &DetectStats::quads_known},
};
constexpr Counter kCounters[] = {
    {"  no four corners", &DetectStats::no_corners},
    {"  sides not straight", &DetectStats::bad_fit},
    {"  shape not a tag's", &DetectStats::bad_shape},
    {"quads", &DetectStats::quads},
    {"  outside the image", &DetectStats::outside_image},
    {"  no contrast", &DetectStats::no_contrast},
    {"  no codeword", &DetectStats::no_codeword},
    {"  low margin", &DetectStats::low_margin},
    {"  duplicates", &DetectStats::duplicates},
    {"detections", &DetectStats::detections},
    {"  refined", &DetectStats::refined_tags},
};

std::string counters_text(std::span<const Counter> counters, const DetectStats& stats) {
  std::string text;
  for (const Counter& counter : counters) {
    text += fmt::format("{:<24}{:>12}\n", counter.name, stats.*counter.count);
  }
  return text;
}

}  // namespace

std::string stats_text(const DetectStats& stats, detect::Algorithm algorithm) {
  const bool paper = algorithm == detect::Algorithm::Paper;
  std::string text =
      paper ? counters_text(kPaperCounters, stats) : counters_text(kTrackerCounters, stats);
  text += counters_text(kCounters, stats);
  for (int i = 0; i < detect::kStages; ++i) {
    const auto stage = static_cast<detect::Stage>(i);
    if (!detect::belongs_to(stage, algorithm)) continue;
    text += fmt::format("{:<24}{:>12.3f} ms\n", detect::name_of(stage),
                        stats.stage_ms[static_cast<std::size_t>(i)]);
  }
  return text;
}

}  // namespace tagmint::cli
