#include "scene/layers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "scene/projection.h"
#include "scene/tag_shape.h"

namespace tagmint::scene {
namespace {

using detect::Point;

/// Rectangles of a plane as the image shows them.
Layer::Outlines projected(std::span<const Rectangle> rectangles, const TagProjection& projection) {
  Layer::Outlines outlines;
  for (const Rectangle& rectangle : rectangles) {
    const std::vector<Point> front = clip_to_front(projection, rectangle);
    std::vector<Point>& outline = outlines.emplace_back();
    for (std::size_t i = 0; i < front.size(); ++i) {
      projection.trace(front[i], front[(i + 1) % front.size()], outline);
    }
  }
  return outlines;
}

double area_of(const Layer::Outlines& outlines) {
  double twice_area = 0;
  for (const auto& outline : outlines) {
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
      twice_area += cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
    }
  }
  return twice_area / 2;
}

Rectangle rectangle_of(const SheetBox& box) {
  const double right = box.left + box.width, bottom = box.top + box.height;
  return {{box.left, box.top}, {right, box.top}, {right, bottom}, {box.left, bottom}};
}

/// The samples of a window that outlines touch.
PixelBox touched_box(const Layer::Outlines& outlines, const Window& window) {
  std::vector<Point> on_grid;
  for (const auto& outline : outlines) {
    for (const Point p : outline) on_grid.push_back(window.to_grid(p));
  }
  return box_of(on_grid, window.columns(), window.rows);
}

/// `coverage` becomes that of outlines on the samples in a box of a window.
void cover(const Layer::Outlines& outlines, const Window& window, const PixelBox& box,
           Coverage& coverage) {
  coverage.reset(box.width(), box.height());
  const Point origin{static_cast<double>(box.x0), static_cast<double>(box.y0)};
  std::vector<Point> on_grid;
  for (const auto& outline : outlines) {
    on_grid.clear();
    for (const Point p : outline) on_grid.push_back(window.to_grid(p) - origin);
    coverage.add(on_grid);
  }
}

}  // namespace

Layer tag_layer(const SceneTag& tag, const detect::Camera& camera, int quiet_zone_cells) {
  const TagProjection projection(tag.place, camera);
  const TagShape shape =
      tag_shape(tag.layout(), tag.family->codeword(tag.id), tag.on_sheet ? 0 : quiet_zone_cells);
  Layer layer;
  layer.tag = projected(shape.tag, projection);
  layer.black = projected(shape.black, projection);
  layer.paper = tag.on_sheet ? layer.black : projected(shape.paper, projection);
  layer.tag_area_px2 = area_of(layer.tag);
  return layer;
}

Layer sheet_layer(const Sheet& sheet, const detect::Camera& camera) {
  // The unit of a tag's plane is half an edge.
  const TagProjection projection(PosedTag{.pose = sheet.pose, .edge_m = 2}, camera);
  std::vector<Rectangle> black;
  for (const SheetBox& box : sheet.black) black.push_back(rectangle_of(box));
  const Rectangle paper = rectangle_of(sheet.paper);
  Layer layer;
  layer.paper = projected({&paper, 1}, projection);
  layer.black = projected(black, projection);
  return layer;
}

void LayerStack::begin(const Window& window, const Effects& levels) {
  window_ = window;
  black_ = static_cast<float>(levels.black);
  white_ = static_cast<float>(levels.white);
  plane_.resize(window.columns(), window.rows);
  open_.resize(window.columns(), window.rows);
  std::fill(plane_.levels.begin(), plane_.levels.end(), 0.0F);
  std::fill(open_.levels.begin(), open_.levels.end(), 1.0F);
}

double LayerStack::add(const Layer& layer, int first, int last) {
  // A tag's cells may be wider than its paper where only its black is printed.
  const PixelBox paper_box = touched_box(layer.paper, window_);
  const PixelBox tag_box = touched_box(layer.tag, window_);
  const PixelBox box{std::min(paper_box.x0, tag_box.x0), std::min(paper_box.y0, tag_box.y0),
                     std::max(paper_box.x1, tag_box.x1), std::max(paper_box.y1, tag_box.y1)};
  if (box.empty()) return 0;
  cover(layer.paper, window_, box, paper_);
  cover(layer.tag, window_, box, tag_);
  cover(layer.black, window_, box, ink_);
  double seen = 0;
  for (int y = box.y0; y < box.y1; ++y) {
    Coverage::Row paper_row = paper_.row(y - box.y0);
    Coverage::Row tag_row = tag_.row(y - box.y0);
    Coverage::Row ink_row = ink_.row(y - box.y0);
    float* level = plane_.row(y);
    float* open = open_.row(y);
    double seen_in_row = 0;
    for (int x = box.x0; x < box.x1; ++x) {
      const auto paper = static_cast<float>(paper_row.next());
      const auto ink = std::min(paper, static_cast<float>(ink_row.next()));
      seen_in_row += open[x] * tag_row.next();
      level[x] += open[x] * (paper * white_ - ink * (white_ - black_));
      open[x] *= 1 - paper;
    }
    const int row = y + window_.first_row;
    if (row >= first && row < last) seen += seen_in_row;
  }
  return seen / (window_.scale * window_.scale);
}

GrayPlane& LayerStack::finish(const GrayPlane& background) {
  for (std::size_t i = 0; i < plane_.levels.size(); ++i) {
    plane_.levels[i] += open_.levels[i] * background.levels[i];
  }
  return plane_;
}

}  // namespace tagmint::scene
