#pragma once

#include <cstdint>
#include <span>

#include "tagmint/codec/export.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Takes the intermediate pictures of one detection. Each function is called at most once an image,
/// in this order, from the thread that called detect(); what the arguments point to is valid during
/// the call alone. Working pixels are those of the decimated image.
class TAGMINT_API DebugSink {
 public:
  virtual ~DebugSink() = default;
  /// The image that quads are looked for in: decimated and blurred.
  virtual void preprocessed(ImageView) {}
  /// 0 = black, 255 = white, 127 = too little contrast.
  virtual void threshold(ImageView) {}
  /// Component of each working pixel, row-major; equal numbers, same component. kNoComponent where
  /// contrast is low.
  virtual void components(std::span<const std::uint32_t> /*labels*/, int /*width*/,
                          int /*height*/) {}
  static constexpr std::uint32_t kNoComponent = 0xffffffff;
  /// Boundary points by cluster: points[cluster_begin[i]] .. points[cluster_begin[i + 1]], in
  /// working pixels.
  virtual void clusters(std::span<const Point> /*points*/,
                        std::span<const std::size_t> /*cluster_begin*/) {}
  /// Candidates in full-resolution pixels, before and after edge refinement.
  virtual void quads(std::span<const Corners>) {}
  virtual void refined_quads(std::span<const Corners>) {}
  virtual void detections(std::span<const Detection>) {}
};

}  // namespace tagmint::detect
