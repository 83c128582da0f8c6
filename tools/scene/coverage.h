#pragma once

#include <algorithm>
#include <cstddef>
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
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

/// The pixels of a width x height image that `points` and what lies between them touch.
PixelBox box_of(std::span<const detect::Point> points, int width, int height);

/// How much of each pixel polygons cover, exactly (to rounding of double).
///
/// Every edge adds to its pixels the signed area between itself and the right end of the row, as a
/// difference: the running sum along a row is then the coverage. Polygons that share an edge add up
/// without a seam, so a tag may be given cell run by cell run.
class Coverage {
 public:
  /// An image without polygons; sides > 0.
  Coverage(int width, int height) { reset(width, height); }
  /// The same again, in the memory that is there.
  void reset(int width, int height);

  /// Adds the area inside `polygon` (px, any place, closed from the last point to the first),
  /// positive when its corners run clockwise as seen (y down). Parts outside the image are cut off.
  ///   cost     the pixels that the edges cross
  void add(std::span<const detect::Point> polygon);

  /// Signed area of all polygons added, the parts outside the image included, px^2.
  double total_area() const { return total_area_; }
  /// Tells the coverage of the pixels of one row, from the left one by one.
  class Row {
   public:
    explicit Row(const double* differences) : differences_(differences) {}
    double next() {
      covered_ += *differences_++;
      return std::clamp(covered_, 0.0, 1.0);
    }

   private:
    const double* differences_;
    double covered_ = 0;
  };
  Row row(int y) const { return Row(differences_.data() + static_cast<std::size_t>(y) * pitch_); }

 private:
  void add_edge(detect::Point a, detect::Point b);
  void add_in_row(double* differences, double xa, double xb, double height);

  int width_ = 0;
  int height_ = 0;
  std::size_t pitch_ = 0;            // doubles a row: width and two more for what lies to the right
  std::vector<double> differences_;  // row-major, height_ * pitch_
  double total_area_ = 0;
};

}  // namespace tagmint::scene
