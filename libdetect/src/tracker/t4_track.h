#pragma once

#include <cstdint>
#include <vector>

#include "tracker/bit_plane.h"

namespace tagmint::detect {

/// A black shape as it was followed downwards: its outermost black pixels row by row.
struct Shape {
  int top = 0;                      ///< first row
  int height = 0;                   ///< rows
  int left_most = 0;                ///< least of left
  int right_most = 0;               ///< largest of right
  std::int64_t area = 0;            ///< pixels from left to right, over all rows
  std::vector<std::int32_t> left;   ///< leftmost black pixel of each row
  std::vector<std::int32_t> right;  ///< rightmost one
};

/// Where shapes of a band of rows have been, so that none is followed twice.
class VisitedBand {
 public:
  /// Forgets everything; rows [first, end) are minded from now on.
  void reset(int first, int end, int width) {
    first_ = first;
    end_ = end;
    stride_ = (static_cast<std::size_t>(width) + 63) / 64;
    bits_.assign(stride_ * static_cast<std::size_t>(end - first), 0);
  }
  /// Rows from y on that are minded.
  int rows_from(int y) const { return end_ - y; }
  /// Words from one row to the next.
  std::size_t stride() const { return stride_; }
  std::uint64_t* row(int y) {
    return bits_.data() + stride_ * static_cast<std::size_t>(y - first_);
  }

 private:
  int first_ = 0;
  int end_ = 0;
  std::size_t stride_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// How a walk down a shape ended.
enum class TrackOutcome {
  Covered,    ///< the run it should begin on has black right above it
  Visited,    ///< it ran into the left side of a shape followed before
  NotConvex,  ///< its sides do not go apart and then together
  Done        ///< came to the lower end
};

/// Stage T4: a run of black with nothing above it -> the shape that hangs on it. Walks down the
/// leftmost and the rightmost black pixels, a step a row: where the pixel below is black, outwards
/// along its run, else inwards to the next black one. No labels, no union-find, no sorting, and the
/// white inside a border is never looked at. A shape whose left side turns left again after it went
/// right (or the reverse for the right side) by more than a few pixels is no quad; the walk ends
/// there, which is what makes texture cheap. Gaps of kMaxGap px in the lower edge are tolerated.
///   black     white is zero, also around the picture
///   x, y      a pixel of the run
///   visited   marks and minds the left sides; y is one of its rows
///   shape     gets the result when Done; its vectors are as long as the picture is high
///   cost      about 4 ns a row
///   source    the idea is that of a throw-away prototype of this project
TrackOutcome track_shape(const BitPlane& black, int x, int y, VisitedBand& visited, Shape& shape);

/// Black pixels that the lower edge of a shape may lack, or stick out by, px.
inline constexpr int kMaxGap = 2;

}  // namespace tagmint::detect
