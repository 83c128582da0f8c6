#include "scene/render.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "scene/background.h"
#include "scene/coverage.h"
#include "scene/effects.h"
#include "scene/light.h"
#include "scene/marks.h"
#include "scene/projection.h"
#include "scene/tag_shape.h"

namespace tagmint::scene {
namespace {

using detect::Point;

/// Adds rectangles of the tag plane, as the image shows them.
void add_projected(const std::vector<Rectangle>& rectangles, const TagProjection& projection,
                   Coverage& coverage) {
  std::vector<Point> outline;
  for (const Rectangle& rectangle : rectangles) {
    const std::vector<Point> front = clip_to_front(projection, rectangle);
    outline.clear();
    for (std::size_t i = 0; i < front.size(); ++i) {
      projection.trace(front[i], front[(i + 1) % front.size()], outline);
    }
    coverage.add(outline);
  }
}

/// Lays tags from the topmost down under what is already there, and counts what stays visible.
class Layers {
 public:
  Layers(int width, int height)
      : plane_(width, height),
        open_(width, height, 1.0F),
        paper_(width, height),
        tag_(width, height),
        white_(width, height) {}

  /// Adds a tag below all earlier ones; returns the visible share of its cells.
  double add(const TagShape& shape, const TagProjection& projection, const Effects& levels) {
    add_projected(shape.paper, projection, paper_);
    add_projected(shape.tag, projection, tag_);
    add_projected(shape.white, projection, white_);
    const double whole = tag_.total_area();
    const double seen = composite(levels);
    paper_.clear();
    tag_.clear();
    white_.clear();
    return whole > 0 ? std::clamp(seen / whole, 0.0, 1.0) : 0;
  }

  /// The background shows where nothing lies.
  GrayPlane finish(const GrayPlane& background) && {
    for (std::size_t i = 0; i < plane_.levels.size(); ++i) {
      plane_.levels[i] += open_.levels[i] * background.levels[i];
    }
    return std::move(plane_);
  }

 private:
  /// Mixes the three coverages into the picture; returns the tag's area that is seen, px^2.
  double composite(const Effects& levels) {
    double seen = 0;
    for (int y = paper_.box().y0; y < paper_.box().y1; ++y) {
      read(paper_, y, paper_row_);
      read(tag_, y, tag_row_);
      read(white_, y, white_row_);
      float* level = plane_.row(y);
      float* open = open_.row(y);
      for (int x = paper_.box().x0; x < paper_.box().x1; ++x) {
        const double paper = at(paper_row_, paper_, x);
        const double white = std::min(paper, at(white_row_, white_, x));
        seen += open[x] * at(tag_row_, tag_, x);
        level[x] +=
            static_cast<float>(open[x] * (white * levels.white + (paper - white) * levels.black));
        open[x] *= static_cast<float>(1 - paper);
      }
    }
    return seen;
  }

  static void read(const Coverage& coverage, int y, std::vector<double>& row) {
    const PixelBox box = coverage.box();
    row.clear();
    if (box.empty() || y < box.y0 || y >= box.y1) return;
    row.resize(static_cast<std::size_t>(box.x1 - box.x0));
    coverage.read_row(y, row);
  }
  static double at(const std::vector<double>& row, const Coverage& coverage, int x) {
    const int i = x - coverage.box().x0;
    return i >= 0 && i < static_cast<int>(row.size()) ? row[static_cast<std::size_t>(i)] : 0;
  }

  GrayPlane plane_;
  GrayPlane open_;  // share of each pixel that no tag covers yet
  Coverage paper_, tag_, white_;
  std::vector<double> paper_row_, tag_row_, white_row_;
};

}  // namespace

Drawing draw_tags(const Scene& scene) {
  Drawing drawing;
  drawing.truth.resize(scene.tags.size());
  Layers layers(scene.width, scene.height);
  for (std::size_t i = scene.tags.size(); i-- > 0;) {
    const SceneTag& tag = scene.tags[i];
    const TagProjection projection(tag, scene.camera);
    const TagShape shape = tag_shape(*tag.family, tag.id, scene.quiet_zone_cells);
    TagTruth& truth = drawing.truth[i];
    truth.corners = projection.corners();
    truth.homography = projection.homography();
    truth.visible = layers.add(shape, projection, scene.effects);
  }
  drawing.plane = std::move(layers).finish(
      draw_background(scene.background, scene.width, scene.height, scene.seed));
  draw_marks(scene.marks, drawing.plane);
  return drawing;
}

Rendering render(const Scene& scene, int threads) {
  check_scene(scene);
  Drawing drawing = draw_tags(scene);
  Rendering rendering{.image = {}, .truth = std::move(drawing.truth)};
  const int cores = tbb::info::default_concurrency();
  tbb::task_arena arena(threads > 0 ? std::min(threads, cores) : cores);
  arena.execute([&] {
    const Effects& effects = scene.effects;
    apply_shading(effects.shading, drawing.plane);
    apply_shadows(effects.shadows, drawing.plane);
    apply_glare(effects.glare, drawing.plane);
    apply_vignetting(effects.vignetting, drawing.plane);
    apply_motion_blur(effects.motion_blur, drawing.plane);
    apply_blur(effects.blur_sigma_px, drawing.plane);
    apply_gamma(effects.gamma, drawing.plane);
    rendering.image = add_noise_and_round(drawing.plane, effects.noise_sigma, scene.seed);
  });
  return rendering;
}

}  // namespace tagmint::scene
