#include "scene/fill.h"

namespace tagmint::scene {

void Painter::fill(std::span<const detect::Point> polygon, double gray) {
  coverage_.add(polygon);
  const PixelBox box = coverage_.box();
  if (!box.empty()) {
    row_.resize(static_cast<std::size_t>(box.x1 - box.x0));
    for (int y = box.y0; y < box.y1; ++y) {
      coverage_.read_row(y, row_);
      float* level = plane_.row(y) + box.x0;
      for (std::size_t i = 0; i < row_.size(); ++i) {
        level[i] += static_cast<float>(row_[i] * (gray - level[i]));
      }
    }
  }
  coverage_.clear();
}

}  // namespace tagmint::scene
