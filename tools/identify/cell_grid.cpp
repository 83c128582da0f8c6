#include "identify/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace tagmint::identify {
namespace {

using detect::Homography;
using detect::ImageView;
using detect::Point;

/// As many pixels of a cell are worth one more sample in each direction, up to a few.
constexpr double kPixelsPerSample = 2.0;
constexpr int kMostSamplesPerSide = 3;
/// The part of a cell, in each direction, that samples are spread over: away from its edges.
constexpr double kCellMiddle = 0.5;

/// Gray value between the centres of the four nearest pixels; at the picture's edge the outermost
/// pixels go on. Nothing outside of the picture.
std::optional<double> gray_at(ImageView picture, Point p) {
  const bool inside = p.x >= 0 && p.y >= 0 && p.x <= picture.width && p.y <= picture.height;
  if (!inside) return std::nullopt;
  const double u = std::clamp(p.x - 0.5, 0.0, picture.width - 1.0);
  const double v = std::clamp(p.y - 0.5, 0.0, picture.height - 1.0);
  const int left = static_cast<int>(u);
  const int top = static_cast<int>(v);
  const int right = std::min(left + 1, picture.width - 1);
  const int bottom = std::min(top + 1, picture.height - 1);
  const double fx = u - left;
  const double fy = v - top;
  return (1 - fy) * ((1 - fx) * picture.at(left, top) + fx * picture.at(right, top)) +
         fy * ((1 - fx) * picture.at(left, bottom) + fx * picture.at(right, bottom));
}

/// Pixels along one side of a cell in the middle of the tag.
double cell_side_px(const Homography& tag_to_image, const Frame& frame) {
  const double half = 1.0 / frame.cells_at_border();
  const Point across = tag_to_image.project({half, 0}) - tag_to_image.project({-half, 0});
  const Point down = tag_to_image.project({0, half}) - tag_to_image.project({0, -half});
  return std::sqrt(std::abs(detect::cross(across, down)));
}

}  // namespace

Frame frame_of(const codec::Layout& layout) { return {layout.width(), layout.border_offset()}; }

Point cell_middle(const Frame& frame, int x, int y) {
  const double cell = 2.0 / frame.cells_at_border();
  return {-1 + (x + 0.5 - frame.border_offset) * cell, -1 + (y + 0.5 - frame.border_offset) * cell};
}

CellGrid CellGrid::mirrored() const {
  CellGrid result(frame_);
  for (int y = 0; y < frame_.width; ++y) {
    for (int x = 0; x < frame_.width; ++x) result.at(x, y) = at(frame_.width - 1 - x, y);
  }
  return result;
}

CellGrid read_cells(ImageView picture, const Homography& tag_to_image, const Frame& frame) {
  CellGrid grid(frame);
  const double side_px = cell_side_px(tag_to_image, frame);
  if (picture.empty() || !std::isfinite(side_px)) return grid;
  const int samples = static_cast<int>(
      std::clamp(side_px / kPixelsPerSample, 1.0, static_cast<double>(kMostSamplesPerSide)));
  const double spread = kCellMiddle * 2.0 / frame.cells_at_border();
  const auto offset = [&](int i) { return ((i + 0.5) / samples - 0.5) * spread; };
  const auto gray_of_cell = [&](Point middle) -> std::optional<double> {
    double sum = 0;
    for (int j = 0; j < samples; ++j) {
      for (int i = 0; i < samples; ++i) {
        const Point at = tag_to_image.project(middle + Point{offset(i), offset(j)});
        const std::optional<double> gray = gray_at(picture, at);
        if (!gray) return std::nullopt;
        sum += *gray;
      }
    }
    return sum / (samples * samples);
  };
  for (int y = 0; y < frame.width; ++y) {
    for (int x = 0; x < frame.width; ++x) grid.at(x, y) = gray_of_cell(cell_middle(frame, x, y));
  }
  return grid;
}

}  // namespace tagmint::identify
