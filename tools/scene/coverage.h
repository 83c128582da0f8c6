#pragma once

#include <span>
#include <vector>

#include "tagmint/detect/geometry.h"

namespace tagmint::scene {

/// A half-open range of pixels.
struct PixelBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

/// How much of each pixel polygons cover, exactly (to rounding of double).
///
/// Every edge adds to its pixels the signed area between itself and the right end of the row, as a
/// difference: the running sum along a row is then the coverage. Polygons that share an edge add up
/// without a seam, so a tag may be given cell run by cell run.
class Coverage {
 public:
  /// An image without polygons; sides > 0.
  Coverage(int width, int height);

  /// Adds the area inside `polygon` (px, any place, closed from the last point to the first),
  /// positive when its corners run clockwise as seen (y down). Parts outside the image are cut off.
  ///   cost     the pixels that the edges cross
  void add(std::span<const detect::Point> polygon);

  /// Signed area of all polygons added, the parts outside the image included, px^2.
  double total_area() const { return total_area_; }
  /// The pixels that may be covered: everything outside is 0.
  PixelBox box() const { return box_; }
  /// Coverage of the pixels box().x0 .. box().x1 of one row; `row` holds that many.
  void read_row(int y, std::span<double> row) const;
  /// Takes all polygons out again. Cost: box().
  void clear();

 private:
  void add_edge(detect::Point a, detect::Point b);
  void add_in_row(double* differences, double xa, double xb, double height);
  void grow_box(std::span<const detect::Point> polygon);

  int width_;
  int height_;
  std::size_t pitch_;                // doubles a row: width and two more for what lies to the right
  std::vector<double> differences_;  // row-major, height_ * pitch_
  double total_area_ = 0;
  PixelBox box_;
};

}  // namespace tagmint::scene
