#include "scene/coverage.h"

#include <algorithm>
#include <cmath>

namespace tagmint::scene {

using detect::Point;

void Coverage::reset(int width, int height) {
  width_ = width;
  height_ = height;
  pitch_ = static_cast<std::size_t>(width) + 2;
  differences_.assign(pitch_ * static_cast<std::size_t>(height), 0.0);
  total_area_ = 0;
}

void Coverage::add(std::span<const Point> polygon) {
  if (polygon.size() < 3) return;
  double twice_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    // About the first corner, so that large coordinates do not cancel.
    twice_area += cross(a - polygon[0], b - polygon[0]);
    add_edge(a, b);
  }
  total_area_ += twice_area / 2;
}

void Coverage::add_edge(Point a, Point b) {
  if (a.y == b.y) return;
  // An edge that runs up has the inside of a clockwise polygon to its right.
  const double sign = b.y < a.y ? 1 : -1;
  const Point top = a.y < b.y ? a : b;
  const Point bottom = a.y < b.y ? b : a;
  const double y_begin = std::max(top.y, 0.0);
  const double y_end = std::min(bottom.y, static_cast<double>(height_));
  const double slope = (bottom.x - top.x) / (bottom.y - top.y);
  const auto x_at = [&](double y) {
    return y >= bottom.y ? bottom.x : top.x + (y - top.y) * slope;
  };
  for (double y = y_begin; y < y_end;) {
    const int row = static_cast<int>(y);
    const double next = std::min(row + 1.0, y_end);
    double* differences = differences_.data() + static_cast<std::size_t>(row) * pitch_;
    add_in_row(differences, x_at(y), x_at(next), sign * (next - y));
    y = next;
  }
}

/// An edge piece inside one row, from x = xa to xb, `height` high (signed).
void Coverage::add_in_row(double* differences, double xa, double xb, double height) {
  if (xa > xb) std::swap(xa, xb);
  const double right = width_;
  if (xa >= right) return;
  if (xb <= 0) {
    differences[0] += height;
    return;
  }
  const double run = xb - xa;
  if (xa < 0) {  // what lies left of the image covers whole rows
    differences[0] += height * (-xa / run);
    height *= xb / run;
    xa = 0;
  }
  if (xb > right) {
    height *= (right - xa) / (xb - xa);
    xb = right;
  }
  // Pixel by pixel: a piece at mean distance d from the pixel's left side leaves 1 - d of it
  // covered, and all pixels further right wholly.
  const bool vertical = xb - xa < 1e-12;
  const double height_per_x = vertical ? 0 : height / (xb - xa);
  for (int x = static_cast<int>(xa);; ++x) {
    const double from = std::max(xa, static_cast<double>(x));
    const double to = std::min(xb, x + 1.0);
    const double piece = vertical ? height : height_per_x * (to - from);
    const double distance = (from + to) / 2 - x;
    differences[x] += piece * (1 - distance);
    differences[x + 1] += piece * distance;
    if (xb <= x + 1.0) break;
  }
}

PixelBox box_of(std::span<const Point> points, int width, int height) {
  PixelBox box{width, height, 0, 0};
  const auto pixel = [](double v, int limit) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(limit)));
  };
  for (const Point p : points) {
    box.x0 = std::min(box.x0, pixel(std::floor(p.x), width));
    box.y0 = std::min(box.y0, pixel(std::floor(p.y), height));
    box.x1 = std::max(box.x1, pixel(std::ceil(p.x), width));
    box.y1 = std::max(box.y1, pixel(std::ceil(p.y), height));
  }
  return box;
}

}  // namespace tagmint::scene
