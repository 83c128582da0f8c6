#pragma once

#include <cstdint>
#include <vector>

#include "tagmint/codec/layout.h"
#include "tagmint/detect/homography.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Gray values of a tag's cells; the memory is kept from one tag to the next.
class CellGrid {
 public:
  /// Reads every cell of a tag: 1 x 1 to 3 x 3 values in its middle half, by its size, and their
  /// mean. A single value is taken between the four nearest pixels; of several, each is the pixel
  /// that it falls into, since their mean evens that out.
  ///   tag_to_image   maps the border square [-1,1]^2
  ///   side_px        mean side of the border square in the image
  ///   cost           about 15 ns a value; places outside the image are looked for only where a
  ///                  corner of the tag is near its edge
  void read(ImageView image, const Homography& tag_to_image, const codec::Layout& layout,
            double side_px);

  int width() const { return width_; }
  /// False where a part of the cell's middle is outside the image.
  bool known(codec::CellPosition p) const { return known_[index(p)] != 0; }
  /// Mean gray value of the cell's middle, 0..255, where it is known.
  float gray(codec::CellPosition p) const { return gray_[index(p)]; }
  /// Middle of a cell in the tag plane.
  Point centre(codec::CellPosition p) const {
    return {origin_ + (p.x + 0.5) * cell_, origin_ + (p.y + 0.5) * cell_};
  }

 private:
  std::size_t index(codec::CellPosition p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(p.x);
  }
  void add_row_of_samples(ImageView image, int row, int count, bool inside, int origin_x,
                          int origin_y);

  int width_ = 0;
  int samples_ = 1;    ///< a side of the cell
  double cell_ = 0;    ///< side of a cell in the tag plane
  double origin_ = 0;  ///< left and top edge of the whole tag in the tag plane
  std::vector<float> gray_;
  std::vector<std::uint8_t> known_;
  // A row of sample points: place in cells, then in pixels.
  std::vector<float> u_;
  std::vector<std::int32_t> x_, y_;
  std::vector<float> fx_, fy_;
};

}  // namespace tagmint::detect
