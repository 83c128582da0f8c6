#include "tracker/t4_track.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace tagmint::detect {
namespace {

/// Sides may go back by this many px before a shape is not convex: noise on a side, steps of a
/// slanted one.
constexpr int kMaxBackward = 4;
/// The turn of the sides is looked at every so many rows (even, a power of two).
constexpr int kRowsPerCheck = 4;
/// Sides may bend inwards by this many px, and one more for every kRowsPerBend rows.
constexpr int kMaxBend = 2;
constexpr int kRowsPerBend = 32;
/// From this height on a shape is large (a multiple of kRowsPerCheck): it may fail a look for every
/// kRowsPerPatience rows of its height, one after another.
constexpr int kPatientRows = 24;
constexpr int kRowsPerPatience = 24;

/// Bits of a window, those that may be anything set to 0.
constexpr std::uint64_t kWindow = (std::uint64_t{1} << kWindowBits) - 1;
constexpr int kLastBit = kWindowBits - 1;

/// First pixel of the run of black that x is in.
int run_begin(const std::uint64_t* row, int x) {
  for (;;) {
    const std::uint64_t white = ~bits_from(row, x - kLastBit) & kWindow;  // the last bit is x
    if (white) return x - (std::countl_zero(white) - (63 - kLastBit)) + 1;
    x -= kWindowBits;  // left of the picture all is white
  }
}

/// Last pixel of the run of black that x is in.
int run_end(const std::uint64_t* row, int x) {
  for (;;) {
    const std::uint64_t white = ~bits_from(row, x) & kWindow;
    if (white) return x + std::countr_zero(white) - 1;
    x += kWindowBits;  // the plane's last bits are white
  }
}

/// Next black pixel to the right of x, at most `last`; last + 1 where there is none.
int next_black(const std::uint64_t* row, int x, int last) {
  for (int at = x + 1; at <= last; at += kWindowBits) {
    const std::uint64_t black = bits_from(row, at) & kWindow;
    if (black) return std::min(at + std::countr_zero(black), last + 1);
  }
  return last + 1;
}

/// Next black pixel to the left of x, at least `first`; first - 1 where there is none.
int previous_black(const std::uint64_t* row, int x, int first) {
  for (int at = x - 1; at >= first; at -= kWindowBits) {
    const std::uint64_t black = bits_from(row, at - kLastBit) & kWindow;
    if (black) return std::max(at - (std::countl_zero(black) - (63 - kLastBit)), first - 1);
  }
  return first - 1;
}

// A step of either side looks at one window with the pixel below in its middle; only steps of half
// a window or more go on from there.
constexpr int kMiddle = kWindowBits / 2;

/// Where a side would be that has ended.
constexpr int kEnded = -1;

/// The left side in `row`, the row below `before`, where it is at `left`.
///   right   the right side in `before`
int step_left(const std::uint64_t* before, const std::uint64_t* row, int left, int right) {
  const std::uint64_t window = bits_from(row, left - kMiddle);
  if (window >> kMiddle & 1) {
    const int run = std::countl_one(window << (63 - kMiddle));
    return run <= kMiddle ? left - run + 1 : run_begin(row, left - kMiddle);
  }
  if (window >> (kMiddle - 1) & 1) return run_begin(row, left - 1);
  const int last = std::min(right, run_end(before, left) + kMaxGap);
  const int next = next_black(row, left, last);
  return next <= last ? next : kEnded;
}

/// The right side, as step_left().
///   left   the left side in `row`
int step_right(const std::uint64_t* before, const std::uint64_t* row, int left, int right) {
  const std::uint64_t window = bits_from(row, right - kMiddle);
  if (window >> kMiddle & 1) {
    const int run = std::countr_one(window >> kMiddle);
    return run < kMiddle ? right + run - 1 : run_end(row, right + kMiddle - 1);
  }
  if (window >> (kMiddle + 1) & 1) return run_end(row, right + 1);
  const int first = std::max(left, run_begin(before, right) - kMaxGap);
  const int next = previous_black(row, right, first);
  return next >= first ? next : kEnded;
}

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
  return next_black(above, first - 1, last) <= last;
}

/// Whether the sides bend inwards by more than noise does: half-way between rows i and k, an even
/// number of rows apart, each must lie outside its chord or near it.
bool bends_inwards(const std::int32_t* lefts, const std::int32_t* rights, int i, int k) {
  const int middle = (i + k) / 2;
  const int most = 2 * kMaxBend + 2 * (k - i) / kRowsPerBend;
  return 2 * lefts[middle] - lefts[i] - lefts[k] > most ||
         rights[i] + rights[k] - 2 * rights[middle] > most;
}

/// Looks at the sides every kRowsPerCheck rows. Large shapes may fail some looks in a row: a speck
/// that touches the border, or a pen's mark, is only so high.
class ConvexityCheck {
 public:
  ConvexityCheck(int left, int right) : left_(-left), right_(right) {}
  /// Whether to go on after row `last`, a multiple of kRowsPerCheck.
  bool goes_on(const std::int32_t* lefts, const std::int32_t* rights, int last) {
    bool convex = !bends_inwards(lefts, rights, 0, last);
    if (last < kPatientRows) {
      convex = left_.goes_on(-lefts[last]) && right_.goes_on(rights[last]) && convex;
      return convex;
    }
    convex = convex && !bends_inwards(lefts, rights, last - kPatientRows, last);
    failed_ = convex ? 0 : failed_ + 1;
    return failed_ <= last / kRowsPerPatience;
  }

 private:
  Turn left_;
  Turn right_;
  int failed_ = 0;
};

/// Marks a pixel of a row; whether it was marked before.
bool visit(std::uint64_t* row, int x) {
  const std::uint64_t bit = std::uint64_t{1} << (x & 63);
  const std::uint64_t word = row[x >> 6];
  row[x >> 6] = word | bit;
  return word & bit;
}

void measure(int top, int height, Shape& shape) {
  shape.top = top;
  shape.height = height;
  shape.left_most = shape.left[0];
  shape.right_most = shape.right[0];
  std::int64_t area = height;
  for (std::size_t i = 0; i < static_cast<std::size_t>(height); ++i) {
    shape.left_most = std::min(shape.left_most, shape.left[i]);
    shape.right_most = std::max(shape.right_most, shape.right[i]);
    area += shape.right[i] - shape.left[i];
  }
  shape.area = area;
}

}  // namespace

TrackOutcome track_shape(const BitPlane& black, int x, int y, VisitedBand& visited, Shape& shape) {
  const std::uint64_t* row = black.row(y);
  int left = run_begin(row, x);
  int right = run_end(row, x);
  if (is_covered(black.row(y - 1), left, right)) return TrackOutcome::Covered;
  const std::size_t stride = black.stride();
  const int rows_left = black.height() - y;
  const int rows_minded = visited.rows_from(y);
  std::uint64_t* visited_row = visited.row(y);
  std::int32_t* const lefts = shape.left.data();
  std::int32_t* const rights = shape.right.data();
  ConvexityCheck check(left, right);
  int height = 0;
  for (;;) {
    if (height < rows_minded) {
      if (visit(visited_row, left)) return TrackOutcome::Visited;
      visited_row += visited.stride();
    }
    lefts[height] = left;
    rights[height] = right;
    if (height % kRowsPerCheck == 0 && height > 0 && !check.goes_on(lefts, rights, height)) {
      return TrackOutcome::NotConvex;
    }
    ++height;
    if (height == rows_left) break;
    const std::uint64_t* const before = row;
    row += stride;
    left = step_left(before, row, left, right);
    if (left == kEnded) break;
    right = step_right(before, row, left, right);
    if (right == kEnded) break;
  }
  measure(y, height, shape);
  return TrackOutcome::Done;
}

}  // namespace tagmint::detect
