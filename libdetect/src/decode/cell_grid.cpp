#include "decode/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "numerics/bilinear.h"

namespace tagmint::detect {
namespace {

/// Share of a ring's cells that must be in the image for its plane to be trusted over the tag.
constexpr double kMinRingShare = 0.5;
/// Rings whose cells scatter about their planes by more than this share of the contrast between the
/// planes are no border: with half the contrast from either plane to the threshold, one cell in
/// thirteen would then be taken for the other colour. Rings of rendered tags have 0.001 to 0.08, of
/// 291 tags in photographs up to 0.23, of quads fitted to noise 0.31 and more (docs/pipeline.md).
constexpr double kMaxRingScatter = 0.35;
/// A cell this many pixels wide, or part of it, is worth one more gray value in each direction...
constexpr double kPixelsPerSample = 2.0;
/// ...up to this many,
constexpr int kMaxSamplesPerSide = 3;
/// spread over this middle part of the cell, away from its blurred edges.
constexpr double kCellMiddle = 0.5;

/// Whether the whole tag, from -extent to extent in its plane, is in the image, a pixel from its
/// edges; then so is every place in it.
bool is_inside(ImageView image, const Homography& tag_to_image, double extent) {
  for (const Point corner : kTagCorners) {
    const Point p = extent * corner;
    if (!(tag_to_image(2, 0) * p.x + tag_to_image(2, 1) * p.y + tag_to_image(2, 2) > 0)) {
      return false;
    }
    const Point at = tag_to_image.project(p);
    if (!(at.x >= 1 && at.y >= 1 && at.x < image.width - 1 && at.y < image.height - 1)) {
      return false;
    }
  }
  return true;
}

}  // namespace

void CellGrid::list_rings() {
  for (int which = 0; which < 2; ++which) {
    std::vector<int>& ring = rings_[which];
    ring.clear();
    const int first = geometry_.border_offset - 1 + which;
    const int last = geometry_.width - 1 - first;
    const auto at = [&](int x, int y) { return y * geometry_.width + x; };
    if (first == last) ring.push_back(at(first, first));
    for (int i = first; i < last; ++i) {
      ring.push_back(at(i, first));
      ring.push_back(at(last, i));
      ring.push_back(at(last - i + first, last));
      ring.push_back(at(first, last - i + first));
    }
  }
}

/// Mean of samples_ x samples_ values about the cell's middle; inside a cell the map is taken for
/// affine.
void CellGrid::read_cell(int index) {
  const Point middle = centre(index);
  const auto& h = map_;
  const double w = 1 / (h[6] * middle.x + h[7] * middle.y + h[8]);
  const Point at{(h[0] * middle.x + h[1] * middle.y + h[2]) * w,
                 (h[3] * middle.x + h[4] * middle.y + h[5]) * w};
  const double scale = kCellMiddle * cell_ / samples_ * w;
  const Point along_x{(h[0] - at.x * h[6]) * scale, (h[3] - at.y * h[6]) * scale};
  const Point along_y{(h[1] - at.x * h[7]) * scale, (h[4] - at.y * h[7]) * scale};
  const std::optional<double> mean = mean_gray(at, along_x, along_y);
  if (!mean) return;
  gray_[index] = static_cast<float>(*mean);
  read_[index] = 1;
}

/// Mean of samples_ x samples_ values around `at`, along_x and along_y apart; nothing where one is
/// outside the image. A single value is taken between the four nearest pixels; of several, each is
/// the pixel that it falls into, since their mean evens that out.
std::optional<double> CellGrid::mean_gray(Point at, Point along_x, Point along_y) const {
  if (samples_ == 1) return inside_ ? sample_inside(full_, at) : sample_bilinear(full_, at);
  const double first = (1 - samples_) / 2.0;
  Point row = at + first * along_x + first * along_y;
  int sum = 0;
  for (int j = 0; j < samples_; ++j, row = row + along_y) {
    Point p = row;
    for (int i = 0; i < samples_; ++i, p = p + along_x) {
      if (!inside_ && !contains(full_, p)) return std::nullopt;
      const int x = std::min(static_cast<int>(p.x), full_.width - 1);
      const int y = std::min(static_cast<int>(p.y), full_.height - 1);
      sum += full_.at(x, y);
    }
  }
  return static_cast<double>(sum) / (samples_ * samples_);
}

/// Nothing when too little of the ring is in the image.
std::optional<CellGrid::Ring> CellGrid::read_ring(int which) {
  const std::vector<int>& cells = rings_[which];
  for (const int cell : cells) read_cell(cell);
  if (cells.size() == 1) {  // a single cell in the middle of the tag has no slope
    if (!is_read(cells[0])) return std::nullopt;
    return Ring{{0, 0, gray(cells[0])}, 1, 0};
  }
  GrayModel model;
  for (const int cell : cells) {
    if (is_read(cell)) model.add(centre(cell), gray(cell));
  }
  if (model.samples() < kMinRingShare * static_cast<double>(cells.size())) return std::nullopt;
  const std::optional<GrayPlane> plane = model.fit();
  if (!plane) return std::nullopt;
  return Ring{*plane, model.samples(), model.squared_residuals(*plane)};
}

BorderOutcome CellGrid::read(ImageView full, const Homography& tag_to_image, double side_px,
                             const GridGeometry& geometry, bool reversed) {
  full_ = full;
  reversed_ = reversed;
  map_ = tag_to_image.row_major();
  if (!(geometry == geometry_)) {
    geometry_ = geometry;
    list_rings();
  }
  cell_ = 2.0 / geometry.width_at_border();
  origin_ = -1.0 - geometry.border_offset * cell_;
  inside_ = is_inside(full, tag_to_image, -origin_);
  const double cell_px = side_px / geometry.width_at_border();
  samples_ = std::clamp(static_cast<int>(cell_px / kPixelsPerSample), 1, kMaxSamplesPerSide);
  const auto cells = static_cast<std::size_t>(geometry.width) * geometry.width;
  gray_.resize(cells);
  read_.assign(cells, 0);

  outcome_ = BorderOutcome::OutsideImage;
  const std::optional<Ring> outside = read_ring(0);
  const std::optional<Ring> inside = read_ring(1);
  if (!outside || !inside) return outcome_;
  black_ = reversed ? outside->plane : inside->plane;
  white_ = reversed ? inside->plane : outside->plane;
  ring_scatter_ = std::sqrt((outside->squared_residuals + inside->squared_residuals) /
                            (outside->cells + inside->cells));
  outcome_ = BorderOutcome::NoContrast;
  if (!(contrast() > 0 && ring_scatter_ <= kMaxRingScatter * contrast())) return outcome_;
  outcome_ = BorderOutcome::Border;
  for (std::size_t i = 0; i < cells; ++i) {
    if (!is_read(static_cast<int>(i))) read_cell(static_cast<int>(i));
  }
  return outcome_;
}

}  // namespace tagmint::detect
