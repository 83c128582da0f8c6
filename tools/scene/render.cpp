#include "scene/render.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "io/images.h"
#include "scene/background.h"
#include "scene/effects.h"
#include "scene/gaussian.h"
#include "scene/layers.h"
#include "scene/light.h"
#include "scene/marks.h"
#include "scene/optics.h"
#include "scene/projection.h"

namespace tagmint::scene {
namespace {

/// All that a scene shows, as outlines in px: what does not depend on the grid it is drawn on.
struct Parts {
  GrayPlane background;
  std::vector<Patch> shapes;  ///< over the background
  struct Item {
    Layer layer;
    std::size_t tag = 0;  ///< its index in the scene; the sheets' are beyond
  };
  std::vector<Item> items;  ///< from the topmost down
  std::vector<Patch> marks;
};

Parts parts_of(const Scene& scene) {
  Parts parts;
  parts.background = draw_background(scene.background, scene.width, scene.height, scene.seed);
  parts.shapes = background_patches(scene.background, scene.width, scene.height, scene.seed);
  std::size_t sheet = scene.sheets.size();
  const auto add_sheets = [&](std::size_t first_tag) {
    for (; sheet > 0 && scene.sheets[sheet - 1].first_tag >= first_tag; --sheet) {
      parts.items.push_back(
          {sheet_layer(scene.sheets[sheet - 1], scene.camera), scene.tags.size()});
    }
  };
  for (std::size_t i = scene.tags.size(); i-- > 0;) {
    add_sheets(i + 1);
    parts.items.push_back({tag_layer(scene.tags[i], scene.camera, scene.quiet_zone_cells), i});
  }
  add_sheets(0);
  parts.marks = mark_patches(scene.marks);
  return parts;
}

/// Memory for one band after another.
struct BandScratch {
  LayerStack stack;
  GrayPlane background;
  PointSpread::Scratch lanes;
};

/// The background on the grid of a window: even within a pixel, with the exact shapes over it.
void draw_background(const Parts& parts, const Window& window, GrayPlane& plane) {
  plane.resize(window.columns(), window.rows);
  for (int row = 0; row < window.rows; ++row) {
    const float* source = parts.background.row((window.first_row + row) / window.scale);
    float* out = plane.row(row);
    for (int x = 0; x < window.width; ++x) {
      out = std::fill_n(out, window.scale, source[x]);
    }
  }
  paint(parts.shapes, window, plane);
}

/// The light that falls on a window. Adds to `seen_px2`, one entry a tag, what the grid rows
/// first .. last - 1 show of it.
const GrayPlane& draw_light(const Scene& scene, const Parts& parts, const Window& window, int first,
                            int last, std::span<double> seen_px2, BandScratch& scratch) {
  scratch.stack.begin(window, scene.effects);
  for (const Parts::Item& item : parts.items) {
    const double seen = scratch.stack.add(item.layer, first, last);
    if (item.tag < seen_px2.size()) seen_px2[item.tag] += seen;
  }
  draw_background(parts, window, scratch.background);
  GrayPlane& plane = scratch.stack.finish(scratch.background);
  paint(parts.marks, window, plane);
  apply_shading(scene.effects.shading, window, plane);
  apply_shadows(scene.effects.shadows, window, plane);
  apply_glare(scene.effects.glare, window, plane);
  apply_vignetting(scene.effects.vignetting, window, plane);
  return plane;
}

std::vector<TagTruth> truth_of(const Scene& scene, const Parts& parts,
                               std::span<const double> seen_px2) {
  std::vector<TagTruth> truth(scene.tags.size());
  for (const Parts::Item& item : parts.items) {
    if (item.tag >= truth.size()) continue;
    const TagProjection projection(scene.tags[item.tag].place, scene.camera);
    TagTruth& tag = truth[item.tag];
    tag.corners = projection.corners();
    tag.homography = projection.homography();
    tag.visible_px = seen_px2[item.tag];
    const double whole = item.layer.tag_area_px2;
    tag.visible = whole > 0 ? std::clamp(tag.visible_px / whole, 0.0, 1.0) : 0;
  }
  return truth;
}

/// What the sensor gets, before its noise.
struct Exposure {
  GrayPlane picture;
  std::vector<TagTruth> truth;
};

/// Draws bands of rows, each for itself: on a grid finer than the pixels a whole picture would not
/// stay in a cache, and would take `scale` squared times its memory.
Exposure expose(const Scene& scene) {
  const Parts parts = parts_of(scene);
  const PointSpread point_spread(scene.effects);
  const int scale = point_spread.scale();
  const int reach = point_spread.reach_rows();
  // Rows about a band are drawn for their blur alone; they are to be the smaller part.
  constexpr int kLeastRows = 16;
  const int band_rows = std::max(kLeastRows, 4 * reach / scale);
  const int bands = (scene.height + band_rows - 1) / band_rows;
  const std::size_t tags = scene.tags.size();
  Exposure exposure{GrayPlane(scene.width, scene.height), {}};
  std::vector<double> seen_px2(static_cast<std::size_t>(bands) * tags);
  tbb::enumerable_thread_specific<BandScratch> scratch;
  tbb::parallel_for(0, bands, [&](int band) {
    const int begin = band * band_rows;
    const int end = std::min(scene.height, begin + band_rows);
    Window window{.width = scene.width, .height = scene.height, .scale = scale};
    window.first_row = std::max(0, begin * scale - reach);
    window.rows = std::min(scene.height * scale, end * scale + reach) - window.first_row;
    const std::span<double> seen = std::span(seen_px2).subspan(band * tags, tags);
    BandScratch& own = scratch.local();
    const GrayPlane& light =
        draw_light(scene, parts, window, begin * scale, end * scale, seen, own);
    point_spread.expose(light, window, begin, end, exposure.picture, own.lanes);
  });
  for (int band = 1; band < bands; ++band) {
    for (std::size_t i = 0; i < tags; ++i) seen_px2[i] += seen_px2[band * tags + i];
  }
  exposure.truth = truth_of(scene, parts, std::span(seen_px2).first(tags));
  if (scene.effects.blur_sigma_px >= PointSpread::kWide_px) {
    apply_blur(scene.effects.blur_sigma_px, exposure.picture);
  }
  return exposure;
}

/// The cores, or what a tbb::global_control says.
int allowed_threads() {
  using tbb::global_control;
  return static_cast<int>(global_control::active_value(global_control::max_allowed_parallelism));
}

}  // namespace

Rendering render(const Scene& scene, int threads) {
  check_scene(scene);
  Rendering rendering;
  tbb::task_arena arena(threads > 0 ? std::min(threads, allowed_threads()) : allowed_threads());
  arena.execute([&] {
    Exposure exposure = expose(scene);
    const Effects& effects = scene.effects;
    apply_shot_noise(effects.electrons_per_level, scene.seed, exposure.picture);
    apply_gamma(effects.gamma, exposure.picture);
    rendering.image = add_noise_and_round(exposure.picture, effects.noise_sigma, scene.seed);
    rendering.truth = std::move(exposure.truth);
  });
  if (scene.effects.jpeg_quality > 0) {
    rendering.jpeg = io::encode_jpeg(rendering.image, scene.effects.jpeg_quality);
    rendering.image = io::decode_gray_image(rendering.jpeg, "the scene's JPEG");
  }
  return rendering;
}

}  // namespace tagmint::scene
