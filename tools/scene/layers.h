#pragma once

#include <span>
#include <vector>

#include "scene/coverage.h"
#include "scene/gray_plane.h"
#include "scene/scene.h"
#include "scene/window.h"

namespace tagmint::scene {

/// A flat thing as the camera sees it, px: outlines clockwise as seen, those of one kind side by
/// side or apart.
struct Layer {
  using Outlines = std::vector<std::vector<detect::Point>>;
  Outlines paper;  ///< all that hides what lies below
  Outlines tag;    ///< the tag's own cells, printed or not
  Outlines black;  ///< inside the paper; the rest of it is white
  double tag_area_px2 = 0;
};

Layer tag_layer(const SceneTag& tag, const detect::Camera& camera, int quiet_zone_cells);
Layer sheet_layer(const Sheet& sheet, const detect::Camera& camera);

/// Lays layers from the topmost down under what is already there, in one window of the picture.
/// May be used for one window after another, in the same memory.
class LayerStack {
 public:
  /// Nothing but the window; `levels`: its black and white are used.
  void begin(const Window& window, const Effects& levels);

  /// Adds a layer below all earlier ones; returns the area of its tag that is seen in the grid rows
  /// first .. last - 1 of the picture, px^2.
  double add(const Layer& layer, int first, int last);

  /// The samples once `background` shows where nothing lies.
  GrayPlane& finish(const GrayPlane& background);

 private:
  Window window_;
  float black_ = 0;
  float white_ = 0;
  GrayPlane plane_;
  GrayPlane open_;  // share of each sample that no layer covers yet
  Coverage paper_{1, 1}, tag_{1, 1}, ink_{1, 1};
};

}  // namespace tagmint::scene
