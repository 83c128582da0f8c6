#pragma once

#include "tagmint/detect/geometry.h"

namespace tagmint::scene {

/// Rows of a picture on a grid of `scale` x `scale` samples a pixel: what is drawn at a time.
struct Window {
  int width = 0;      ///< of the whole picture, px
  int height = 0;     ///< of the whole picture, px
  int scale = 1;      ///< grid samples along a pixel's side
  int first_row = 0;  ///< of the grid, 0 .. height * scale
  int rows = 0;       ///< of the grid

  /// All of a picture, one sample a pixel.
  static Window whole(int width, int height) { return {width, height, 1, 0, height}; }

  int columns() const { return width * scale; }
  /// A place of the picture (px) in the window's own samples.
  detect::Point to_grid(detect::Point px) const { return {px.x * scale, px.y * scale - first_row}; }
  /// The centre of a sample, px.
  double x_px(int column) const { return (column + 0.5) / scale; }
  double y_px(int row) const { return (first_row + row + 0.5) / scale; }
};

}  // namespace tagmint::scene
