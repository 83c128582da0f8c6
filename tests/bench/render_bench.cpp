// Drawing pictures of 640 x 480 with eight tags, by what the light and the camera do; real time on
// the number of threads that is the argument (0: all).

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "scene/random_scene.h"
#include "scene/render.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::scene {
namespace {

using Change = std::function<void(RandomSceneOptions&)>;

void draw(benchmark::State& state, const Change& change) {
  RandomSceneOptions options;
  change(options);
  const std::vector<TagChoice> choices = {{codec::find_family("tag36h11"), {}}};
  const Scene scene = random_scene(choices, options);
  for (auto _ : state) {
    const Rendering rendering = render(scene, static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(rendering.image.row(0));
    if (rendering.truth.size() != 8) state.SkipWithError("a tag found no room");
  }
}

const std::vector<std::pair<std::string, Change>> kKinds = {
    {"plain", [](auto& o) { o.background = PlainBackground{}; }},
    {"texture", [](auto&) {}},
    {"blur 0.3", [](auto& o) { o.effects.blur_sigma_px = 0.3; }},
    {"blur 0.5", [](auto& o) { o.effects.blur_sigma_px = 0.5; }},
    {"blur 0.7", [](auto& o) { o.effects.blur_sigma_px = 0.7; }},
    {"blur 0.7, shading 0.2, noise 2",
     [](auto& o) {
       o.effects.shading = {.strength = 0.2, .angle_deg = 30};
       o.effects.blur_sigma_px = 0.7;
       o.effects.noise_sigma = 2;
     }},
    {"blur 2", [](auto& o) { o.effects.blur_sigma_px = 2; }},
    {"blur 5", [](auto& o) { o.effects.blur_sigma_px = 5; }},
    {"clutter, blur 0.7",
     [](auto& o) {
       o.background = ClutterBackground{};
       o.effects.blur_sigma_px = 0.7;
     }},
    {"defocus 2", [](auto& o) { o.effects.defocus_px = 2; }},
    {"motion 6", [](auto& o) { o.effects.motion_blur = {.length_px = 6, .angle_deg = 30}; }},
    {"motion 6, blur 0.7",
     [](auto& o) {
       o.effects.motion_blur = {.length_px = 6, .angle_deg = 30};
       o.effects.blur_sigma_px = 0.7;
     }},
    {"shot noise", [](auto& o) { o.effects.electrons_per_level = 40; }},
    {"everything",
     [](auto& o) {
       o.background = ClutterBackground{};
       o.effects.shading = {.strength = 0.2, .angle_deg = 30};
       o.effects.shadows = {{.polygon = {{0, 0}, {400, 0}, {200, 480}, {0, 480}}}};
       o.effects.glare = {{.centre = {320, 200}}};
       o.effects.vignetting = 0.3;
       o.effects.motion_blur = {.length_px = 3, .angle_deg = 30};
       o.effects.defocus_px = 1;
       o.effects.blur_sigma_px = 0.7;
       o.effects.electrons_per_level = 40;
       o.effects.gamma = 2.2;
       o.effects.noise_sigma = 2;
       o.effects.jpeg_quality = 80;
     }},
};

[[maybe_unused]] const bool kRegistered = [] {
  for (const auto& [name, change] : kKinds) {
    benchmark::RegisterBenchmark(("render/" + name).c_str(), draw, change)
        ->Arg(1)
        ->Arg(0)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
  return true;
}();

}  // namespace
}  // namespace tagmint::scene
