#pragma once

#include <cstddef>
#include <vector>

namespace tagmint::scene {

/// Gray levels before rounding, 0 .. 255 nominally; rows without padding.
struct GrayPlane {
  int width = 0;
  int height = 0;
  std::vector<float> levels;

  GrayPlane() = default;
  GrayPlane(int w, int h, float level = 0)
      : width(w), height(h), levels(static_cast<std::size_t>(w) * h, level) {}
  /// Another size, in the memory that is there; levels are whatever they were.
  void resize(int w, int h) {
    width = w;
    height = h;
    levels.resize(static_cast<std::size_t>(w) * h);
  }
  float* row(int y) { return levels.data() + static_cast<std::size_t>(y) * width; }
  const float* row(int y) const { return levels.data() + static_cast<std::size_t>(y) * width; }
};

}  // namespace tagmint::scene
