#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tagmint/detect/debug_sink.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// Values of the thresholded image.
inline constexpr std::uint8_t kBlack = 0;
inline constexpr std::uint8_t kUnknown = 127;
inline constexpr std::uint8_t kWhite = 255;

/// Label of a pixel that belongs to no component.
inline constexpr std::uint32_t kNoComponent = DebugSink::kNoComponent;

/// A horizontal stretch of pixels of one value, [begin, end) in its row.
struct PixelRun {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  std::uint32_t component = 0;
  std::uint8_t value = 0;  ///< kBlack or kWhite
};

/// Pixels left to right - 1 and top to bottom - 1.
struct PixelBox {
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t right = 0;
  std::int32_t bottom = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The connected components of an image, as runs: rows of a picture have far fewer runs than
/// pixels, and all pixels of a run share everything that later stages ask for.
struct Components {
  int width = 0;
  int height = 0;
  std::vector<PixelRun> runs;          ///< black and white runs, row by row, by x; none is unknown
  std::vector<std::size_t> row_begin;  ///< row y is runs[row_begin[y]] .. runs[row_begin[y + 1]]
  std::vector<std::uint32_t> size;     ///< pixels in each component
  std::vector<PixelBox> box;           ///< smallest about each component

  std::size_t count() const { return size.size(); }
};

/// A point half-way between a black and a white pixel that are neighbours [WangOlson2016, Fig. 4].
struct BoundaryPoint {
  float x = 0;  ///< working pixels, (0.5, 0.5) is the centre of the first pixel
  float y = 0;
  float gx =
      0;  ///< direction from the black pixel to the white one, one of the eight neighbour steps
  float gy = 0;
};

/// Boundary points grouped by the pair of components that they separate.
struct Clusters {
  std::vector<BoundaryPoint> points;
  std::vector<std::size_t>
      begin;  ///< cluster i is points[begin[i]] .. points[begin[i + 1]]; size count + 1

  std::size_t count() const { return begin.empty() ? 0 : begin.size() - 1; }
  std::span<const BoundaryPoint> cluster(std::size_t i) const {
    return std::span(points).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// A candidate border square, corners counter-clockwise as seen (y down), like Corners.
struct Quad {
  Corners corners;
  bool reversed_border = false;  ///< white inside black
};

}  // namespace tagmint::detect
