#include "tracker/t4_track.h"

#include <algorithm>
#include <bit>

namespace tagmint::detect {
namespace {

/// Sides may go back by this many px before a shape is not convex: noise on a side, steps of a
/// slanted one.
constexpr int kMaxBackward = 4;
/// The turn of the sides is looked at every so many rows (a power of two).
constexpr int kRowsPerCheck = 4;

/// First pixel of the run of black that (x) is in.
int run_begin(const std::uint64_t* row, int x) {
  for (;;) {
    const std::uint64_t white = ~bits_from(row, x - 63);  // bit 63 is x
    if (white) return x - std::countl_zero(white) + 1;
    x -= 64;  // left of the picture all is white
  }
}

/// Last pixel of the run of black that (x) is in.
int run_end(const std::uint64_t* row, int x) {
  for (;;) {
    const std::uint64_t white = ~bits_from(row, x);
    if (white) return x + std::countr_zero(white) - 1;
    x += 64;  // the plane's last bits are white
  }
}

/// Next black pixel to the right of x, at most `last`; last + 1 where there is none.
int next_black(const std::uint64_t* row, int x, int last) {
  for (int at = x + 1; at <= last; at += 64) {
    const std::uint64_t black = bits_from(row, at);
    if (black) return std::min(at + std::countr_zero(black), last + 1);
  }
  return last + 1;
}

/// Next black pixel to the left of x, at least `first`; first - 1 where there is none.
int previous_black(const std::uint64_t* row, int x, int first) {
  for (int at = x - 1; at >= first; at -= 64) {
    const std::uint64_t black = bits_from(row, at - 63);
    if (black) return std::max(at - std::countl_zero(black), first - 1);
  }
  return first - 1;
}

bool is_black(const std::uint64_t* row, int x) { return row[x >> 6] >> (x & 63) & 1; }

/// Whether a side goes out, then in, each time with some tolerance. Works for the right side; the
/// left one is its mirror image.
class Turn {
 public:
  explicit Turn(int x) : extreme_(x) {}
  /// False when the side goes out again.
  bool goes_on(int x) {
    if (!inwards_) {
      if (x > extreme_) {
        extreme_ = x;
      } else if (x < extreme_ - kMaxBackward) {
        inwards_ = true;
        extreme_ = x;
      }
      return true;
    }
    extreme_ = std::min(extreme_, x);
    return x <= extreme_ + kMaxBackward;
  }

 private:
  int extreme_;
  bool inwards_ = false;
};

/// Whether a run has black right above one of its pixels.
bool is_covered(const std::uint64_t* above, int first, int last) {
  return is_black(above, first) || next_black(above, first, last) <= last;
}

}  // namespace

TrackOutcome track_shape(const BitPlane& black, int x, int y, VisitedBand& visited, Shape& shape) {
  const std::uint64_t* row = black.row(y);
  int left = run_begin(row, x);
  int right = run_end(row, x);
  if (is_covered(black.row(y - 1), left, right)) return TrackOutcome::Covered;
  const std::size_t stride = black.stride();
  const int rows_left = black.height() - y;
  std::int32_t* const lefts = shape.left.data();
  std::int32_t* const rights = shape.right.data();
  Turn left_turn(-left);
  Turn right_turn(right);
  int left_most = left;
  int right_most = right;
  std::int64_t area = 0;
  int height = 0;
  for (;;) {
    if (visited.visit(left, y + height)) return TrackOutcome::Visited;
    lefts[height] = left;
    rights[height] = right;
    ++height;
    area += right - left + 1;
    left_most = std::min(left_most, left);
    right_most = std::max(right_most, right);
    if (height % kRowsPerCheck == 0 && !(left_turn.goes_on(-left) && right_turn.goes_on(right))) {
      return TrackOutcome::NotConvex;
    }
    if (height == rows_left) break;
    const std::uint64_t* const before = row;
    row += stride;
    const int old_left = left;
    const int old_right = right;
    if (is_black(row, left)) {
      left = run_begin(row, left);
    } else {
      const int last = std::min(right, run_end(before, old_left) + kMaxGap);
      left = next_black(row, left, last);
      if (left > last) break;
    }
    if (is_black(row, right)) {
      right = run_end(row, right);
    } else {
      const int first = std::max(left, run_begin(before, old_right) - kMaxGap);
      right = previous_black(row, right, first);
      if (right < first) break;
    }
  }
  shape.top = y;
  shape.height = height;
  shape.left_most = left_most;
  shape.right_most = right_most;
  shape.area = area;
  return TrackOutcome::Done;
}

}  // namespace tagmint::detect
