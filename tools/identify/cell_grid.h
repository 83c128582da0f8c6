#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "tagmint/codec/layout.h"
#include "tagmint/detect/homography.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::identify {

/// How many cells a tag has, and where in them its border square is. Layouts of one frame are read
/// at the same places.
struct Frame {
  int width = 0;          ///< cells of the whole tag
  int border_offset = 0;  ///< cells from its outer edge to the border square

  int cells_at_border() const { return width - 2 * border_offset; }
  friend auto operator<=>(const Frame&, const Frame&) = default;
};
Frame frame_of(const codec::Layout& layout);

/// The middle of cell (x, y) in the tag plane, where the border square is [-1, 1]^2.
detect::Point cell_middle(const Frame& frame, int x, int y);

/// Gray values of the cells of a tag; nothing for cells that are outside of the picture.
class CellGrid {
 public:
  explicit CellGrid(const Frame& frame)
      : frame_(frame), gray_(static_cast<std::size_t>(frame.width) * frame.width) {}

  const Frame& frame() const { return frame_; }
  /// 0 <= x, y < frame().width
  std::optional<double>& at(int x, int y) { return gray_[place(x, y)]; }
  const std::optional<double>& at(int x, int y) const { return gray_[place(x, y)]; }
  /// The grid of the picture with left and right exchanged.
  CellGrid mirrored() const;

 private:
  std::size_t place(int x, int y) const { return static_cast<std::size_t>(y) * frame_.width + x; }

  Frame frame_;
  std::vector<std::optional<double>> gray_;
};

/// Reads the middles of all cells: up to three by three samples each, spread over the middle half
/// of the cell.
///   tag_to_image   maps the border square [-1, 1]^2 to pixels
///   cost           up to nine bilinear samples a cell
CellGrid read_cells(detect::ImageView picture, const detect::Homography& tag_to_image,
                    const Frame& frame);

}  // namespace tagmint::identify
