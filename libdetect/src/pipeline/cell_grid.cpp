#include "pipeline/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/project_kernels.h"
#include "numerics/bilinear.h"

namespace tagmint::detect {
namespace {

/// A cell this many pixels wide, or part of it, is worth one more gray value in each direction...
constexpr double kPixelsPerSample = 2.0;
/// ...up to this many,
constexpr int kMaxSamplesPerSide = 3;
/// spread over this middle part of the cell, away from its blurred edges.
constexpr double kCellMiddle = 0.5;

/// tag_to_image after cell coordinates -> tag plane, with (origin_x, origin_y) as the origin of the
/// pixels: near there, floats are exact enough.
ProjectiveFloats cells_to_pixels(const Homography& tag_to_image, double cell, double origin,
                                 int origin_x, int origin_y) {
  ProjectiveFloats map;
  const std::array<double, 9>& h = tag_to_image.row_major();
  std::array<double, 9> m;
  for (std::size_t row = 0; row < 3; ++row) {
    m[3 * row] = h[3 * row] * cell;
    m[3 * row + 1] = h[3 * row + 1] * cell;
    m[3 * row + 2] = (h[3 * row] + h[3 * row + 1]) * origin + h[3 * row + 2];
  }
  for (std::size_t column = 0; column < 3; ++column) {
    map[column] = static_cast<float>(m[column] - origin_x * m[6 + column]);
    map[3 + column] = static_cast<float>(m[3 + column] - origin_y * m[6 + column]);
    map[6 + column] = static_cast<float>(m[6 + column]);
  }
  return map;
}

/// Whether the whole tag, from -extent to extent in its plane, is in the image, a pixel from its
/// edges; then so is every place in it.
bool is_inside(ImageView image, const Homography& tag_to_image, double extent) {
  const std::array<double, 9>& h = tag_to_image.row_major();
  for (const Point corner : kTagCorners) {
    const Point p = extent * corner;
    if (!(h[6] * p.x + h[7] * p.y + h[8] > 0)) return false;
    const Point at = tag_to_image.project(p);
    if (!(at.x >= 1 && at.y >= 1 && at.x < image.width - 1 && at.y < image.height - 1)) {
      return false;
    }
  }
  return true;
}

}  // namespace

/// Adds one row of samples to the cells of `row`, `count` in all.
void CellGrid::add_row_of_samples(ImageView image, int row, int count, bool inside, int origin_x,
                                  int origin_y) {
  float* const gray =
      gray_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
  std::uint8_t* const known =
      known_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto cell = static_cast<std::size_t>(i / samples_);
    const int x = origin_x + x_[k];
    const int y = origin_y + y_[k];
    if (samples_ > 1) {
      if (inside || (x >= 0 && y >= 0 && x < image.width && y < image.height)) {
        gray[cell] += image.row(y)[x];
      } else {
        known[cell] = 0;
      }
      continue;
    }
    if (inside) {
      // The value of a pixel is that of its middle.
      const float u = fx_[k] - 0.5f;
      const float v = fy_[k] - 0.5f;
      const int left = u < 0 ? x - 1 : x;
      const int top = v < 0 ? y - 1 : y;
      const float a = u < 0 ? u + 1 : u;
      const float b = v < 0 ? v + 1 : v;
      const std::uint8_t* upper = image.row(top) + left;
      const std::uint8_t* lower = image.row(top + 1) + left;
      const float at_top =
          static_cast<float>(upper[0]) + a * static_cast<float>(upper[1] - upper[0]);
      const float at_bottom =
          static_cast<float>(lower[0]) + a * static_cast<float>(lower[1] - lower[0]);
      gray[cell] = at_top + b * (at_bottom - at_top);
    } else if (const auto value =
                   sample_bilinear(image, {static_cast<double>(x) + static_cast<double>(fx_[k]),
                                           static_cast<double>(y) + static_cast<double>(fy_[k])})) {
      gray[cell] = static_cast<float>(*value);
    } else {
      known[cell] = 0;
    }
  }
}

void CellGrid::read(ImageView image, const Homography& tag_to_image, const codec::Layout& layout,
                    double side_px) {
  width_ = layout.width();
  cell_ = 2.0 / layout.width_at_border();
  origin_ = -1.0 - layout.border_offset() * cell_;
  const double cell_px = side_px / layout.width_at_border();
  samples_ = std::clamp(static_cast<int>(cell_px / kPixelsPerSample), 1, kMaxSamplesPerSide);
  const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(width_);
  gray_.assign(cells, 0.0f);
  known_.assign(cells, 1);

  const int count = width_ * samples_;
  const auto padded = static_cast<std::size_t>(count + kProjectPadding);
  if (u_.size() < padded) {
    for (auto* floats : {&u_, &fx_, &fy_}) floats->resize(padded);
    for (auto* whole : {&x_, &y_}) whole->resize(padded);
  }
  const auto place = [&](int i) {
    const int part = i % samples_;
    return static_cast<float>(i / samples_ + 0.5 + ((part + 0.5) / samples_ - 0.5) * kCellMiddle);
  };
  for (int i = 0; i < count; ++i) u_[static_cast<std::size_t>(i)] = place(i);
  std::fill(u_.begin() + count, u_.begin() + count + kProjectPadding, place(count - 1));

  const bool inside = is_inside(image, tag_to_image, -origin_);
  const Point middle = tag_to_image.project({0, 0});
  const int origin_x = static_cast<int>(std::clamp(middle.x, 0.0, image.width - 1.0));
  const int origin_y = static_cast<int>(std::clamp(middle.y, 0.0, image.height - 1.0));
  const ProjectiveFloats map = cells_to_pixels(tag_to_image, cell_, origin_, origin_x, origin_y);
  const PixelPlaces places{x_.data(), y_.data(), fx_.data(), fy_.data()};
  for (int row = 0; row < count; ++row) {
    project_row(map, u_.data(), place(row), count, places);
    add_row_of_samples(image, row / samples_, count, inside, origin_x, origin_y);
  }
  if (samples_ > 1) {
    const float share = 1.0f / static_cast<float>(samples_ * samples_);
    for (float& gray : gray_) gray *= share;
  }
}

}  // namespace tagmint::detect
