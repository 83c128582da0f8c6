#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "numerics/gray_model.h"
#include "tagmint/codec/layout.h"
#include "tagmint/detect/homography.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// What decides where the cells of a quad are, whatever they mean: layouts of one geometry share
/// the gray values of a quad.
struct GridGeometry {
  int width = 0;          ///< side of the whole tag, cells
  int border_offset = 0;  ///< from its outer edge to the border square, cells

  static GridGeometry of(const codec::Layout& layout) {
    return {layout.width(), layout.border_offset()};
  }
  int width_at_border() const { return width - 2 * border_offset; }
  friend bool operator==(const GridGeometry&, const GridGeometry&) = default;
};

/// How the rings at the border square look.
enum class BorderOutcome {
  OutsideImage,  ///< too much of them is not in the picture
  NoContrast,    ///< the ring that should be darker is not, or they are uneven
  Border
};

/// The gray values of one quad's cells, and the planes of black and white that its rings tell.
class CellGrid {
 public:
  /// Reads the rings, and the other cells where they are those of a border.
  ///   tag_to_image   of the quad as it was found
  ///   side_px        mean side of the quad
  ///   reversed       white inside black
  BorderOutcome read(ImageView full, const Homography& tag_to_image, double side_px,
                     const GridGeometry& geometry, bool reversed);

  const GridGeometry& geometry() const { return geometry_; }
  BorderOutcome outcome() const { return outcome_; }
  int index(codec::CellPosition p) const { return p.y * geometry_.width + p.x; }
  /// Whether the cell's middle is in the image; otherwise gray() is not to be asked for.
  bool is_read(int index) const { return read_[index] != 0; }
  double gray(int index) const { return gray_[index]; }
  /// Black and white there, from the planes.
  double black(int index) const { return black_.at(centre(index)); }
  double white(int index) const { return white_.at(centre(index)); }
  double threshold(int index) const { return (black(index) + white(index)) / 2; }
  double half_contrast(int index) const { return (white(index) - black(index)) / 2; }
  /// Root mean square of the rings' cells about their planes, gray levels.
  double ring_scatter() const { return ring_scatter_; }
  /// Between the planes in the middle of the tag.
  double contrast() const { return white_.c0 - black_.c0; }
  /// White inside black.
  bool reversed() const { return reversed_; }
  /// The ring of cells outside (0) or inside (1) of the border square, by index.
  const std::vector<int>& ring(int which) const { return rings_[which]; }

 private:
  struct Ring {
    GrayPlane plane;
    int cells = 0;
    double squared_residuals = 0;
  };

  void list_rings();
  void read_cell(int index);
  std::optional<double> mean_gray(Point at, Point along_x, Point along_y) const;
  std::optional<Ring> read_ring(int which);
  Point centre(int index) const {
    return {origin_ + (index % geometry_.width + 0.5) * cell_,
            origin_ + (index / geometry_.width + 0.5) * cell_};
  }

  ImageView full_;
  std::array<double, 9> map_{};
  GridGeometry geometry_;
  bool reversed_ = false;
  bool inside_ = false;  // all cells are in the image
  BorderOutcome outcome_ = BorderOutcome::OutsideImage;
  double cell_ = 0;    // side of a cell in the tag plane
  double origin_ = 0;  // left and top edge of the whole tag in the tag plane
  int samples_ = 1;    // a side of the cell
  std::vector<float> gray_;
  std::vector<std::uint8_t> read_;
  std::vector<int> rings_[2];
  GrayPlane black_;
  GrayPlane white_;
  double ring_scatter_ = 0;
};

}  // namespace tagmint::detect
