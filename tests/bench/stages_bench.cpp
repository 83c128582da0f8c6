// How long each stage of the paper's path takes on one rendered picture, and the whole detector.
// Rates are pixels of the full picture per second. Beside its peers detector_bench measures it.

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "support/fixed_random.h"
#include "support/front_half.h"
#include "support/paint_tags.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/detect/detector.h"

namespace tagmint {
namespace {

using detect::ImageView;

constexpr int kWidth = 1280;
constexpr int kHeight = 960;
constexpr int kTags = 48;

/// 48 tags of 30 to 90 px in any direction on gray ground that is brighter to the right.
detect::Image scene_with_noise(double noise_sigma) {
  testing::Canvas canvas(kWidth, kHeight, 0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) canvas.at(x, y) = 90 + 80.0f * x / kWidth;
  }
  testing::FixedRandom random(1);
  const codec::SharedFamily family = codec::find_family("tag36h11");
  for (int i = 0; i < kTags; ++i) {
    const detect::Point centre{80 + 160.0 * (i % 8), 80 + 160.0 * (i / 8)};
    const double side = random.real(30, 90);
    const auto map = testing::square_at(centre, side, random.real(0, 6.28));
    testing::paint_tag(canvas, *family, static_cast<codec::TagId>(i), map);
  }
  testing::blur(canvas, 0.7);
  return testing::to_gray(canvas, noise_sigma, random);
}

/// The picture for a benchmark's argument: the noise's standard deviation in gray levels.
const detect::Image& scene(const benchmark::State& state) {
  static const detect::Image clean = scene_with_noise(0), noisy = scene_with_noise(5);
  return state.range(0) == 0 ? clean : noisy;
}

void count_pixels(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
}

void Preprocess(benchmark::State& state) {
  const detect::Image& image = scene(state);
  testing::FrontHalf front;
  front.preprocess.decimate = 0.5 * static_cast<double>(state.range(1));
  front.preprocess.blur_sigma_px = static_cast<double>(state.range(2));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        detect::preprocess(image, front.preprocess, front.preprocess_scratch, front.working_image));
  }
  count_pixels(state);
}
BENCHMARK(Preprocess)
    ->ArgNames({"noise", "twice_decimate", "blur"})
    ->Args({0, 3, 0})
    ->Args({0, 4, 0})
    ->Args({0, 2, 1});

void Threshold(benchmark::State& state) {
  const detect::Image& image = scene(state);
  testing::FrontHalf front;
  for (auto _ : state) {
    detect::threshold(image, front.threshold, front.threshold_scratch, front.three_valued);
  }
  count_pixels(state);
}
BENCHMARK(Threshold)->ArgName("noise")->Arg(0)->Arg(5);

void Segment(benchmark::State& state) {
  testing::FrontHalf front;
  front.quads(scene(state));
  for (auto _ : state) {
    detect::segment(front.three_valued, front.segment_scratch, front.components);
  }
  count_pixels(state);
}
BENCHMARK(Segment)->ArgName("noise")->Arg(0)->Arg(5);

void Cluster(benchmark::State& state) {
  testing::FrontHalf front;
  front.cluster.min_component_pixels = detect::smallest_ring_pixels(4);
  front.quads(scene(state));
  for (auto _ : state) {
    detect::cluster(front.components, front.cluster, front.cluster_scratch, front.clusters,
                    front.stats);
  }
  count_pixels(state);
}
BENCHMARK(Cluster)->ArgName("noise")->Arg(0)->Arg(5);

void FitQuads(benchmark::State& state) {
  const detect::Image& image = scene(state);
  testing::FrontHalf front;
  front.cluster.min_component_pixels = detect::smallest_ring_pixels(4);
  front.quad.reversed_borders = false;
  front.quads(image);
  std::size_t quads = 0;
  for (auto _ : state) {
    quads = 0;
    for (std::size_t i = 0; i < front.clusters.count(); ++i) {
      quads += detect::fit_quad(front.clusters.cluster(i), image, front.quad, front.quad_scratch,
                                front.stats)
                   .has_value();
    }
  }
  if (quads < kTags) state.SkipWithError("a tag has no quad");
  state.counters["clusters"] = static_cast<double>(front.clusters.count());
  state.counters["quads"] = static_cast<double>(quads);
  count_pixels(state);
}
BENCHMARK(FitQuads)->ArgName("noise")->Arg(0)->Arg(5);

void WholeDetector(benchmark::State& state) {
  const detect::Image& image = scene(state);
  detect::DetectorOptions options;
  options.algorithm = detect::Algorithm::Paper;
  options.decimate = static_cast<double>(state.range(1));
  detect::Detector detector(
      {std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"))}, options);
  std::size_t found = 0;
  for (auto _ : state) found = detector.detect(image).size();
  if (found < kTags && options.decimate == 1) state.SkipWithError("a tag was not found");
  state.counters["tags"] = static_cast<double>(found);
  count_pixels(state);
}
BENCHMARK(WholeDetector)->ArgNames({"noise", "decimate"})->ArgsProduct({{0, 5}, {1, 2}});

}  // namespace
}  // namespace tagmint
