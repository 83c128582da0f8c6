#pragma once

#include <vector>

#include "scene/gray_plane.h"
#include "scene/kernel.h"
#include "scene/scene.h"
#include "scene/window.h"

namespace tagmint::scene {

/// What lens and shutter make of a point of light, as a pixel sees it: motion, defocus, a narrow
/// Gaussian and the pixel's square in one kernel on a grid finer than the pixels. So blur is that
/// of the light before the pixels, to 0.2 % of an edge's contrast.
class PointSpread {
 public:
  /// A Gaussian of at least this sigma is as good between finished pixels; it is not part of the
  /// point-spread, apply_blur() follows.
  static constexpr double kWide_px = 3;

  /// The optical effects are looked at; they must have passed check_scene().
  explicit PointSpread(const Effects& effects);

  /// Grid samples along a pixel's side, 1..8.
  int scale() const { return scale_; }
  /// Grid rows that a pixel sees above its own and below them.
  int reach_rows() const { return -first_; }

  /// Memory of one thread, for one call after another.
  using Scratch = std::vector<float>;

  /// Exposes rows of pixels; beyond the picture's edges its last samples go on.
  ///   light     the samples of `window`, which holds all rows that the pixels see
  ///   begin     rows begin .. end - 1 of `picture` are written
  ///   cost      a multiplication for each pixel and sample of the kernel; where it is a Gaussian
  ///             alone, as many as its two sides
  void expose(const GrayPlane& light, const Window& window, int begin, int end, GrayPlane& picture,
              Scratch& scratch) const;

 private:
  /// A kernel sample: of a pixel's kernel row and column, from first_ on.
  struct Tap {
    int row = 0;
    int column = 0;
    float weight = 0;
  };

  void set_taps(const Kernel& kernel);
  void expose_separably(const GrayPlane& light, const Window& window, int begin, int end,
                        GrayPlane& picture, Scratch& scratch) const;

  int scale_ = 1;
  int first_ = 0;  // grid place of the kernel's first row and column, from the pixel's own
  int size_ = 1;   // rows and columns of the kernel
  std::vector<float> line_;  // of a kernel that is the same along rows and columns, else empty
  std::vector<Tap> taps_;    // of any other, by rows
};

}  // namespace tagmint::scene
