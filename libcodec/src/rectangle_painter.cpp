#include "rectangle_painter.h"

#include <algorithm>
#include <array>

namespace tagmint::codec {
namespace {

constexpr int kNoBit = -1;

/// A painted rectangle, both ends included.
struct Rectangle {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int colour = 0;
  int gain = 0;  // wrong cells before minus wrong cells after
};

/// The picture to be painted and what painting one cell would gain.
class Canvas {
 public:
  Canvas(int side, const std::vector<int>& bit_shift, Codeword word)
      : side_(side), wanted_(bit_shift.size()), column_(side) {
    gain_.assign(bit_shift.size(), {0, 0});
    for (std::size_t i = 0; i < bit_shift.size(); ++i) {
      if (bit_shift[i] == kNoBit) {
        wanted_[i] = kNoBit;
        continue;
      }
      wanted_[i] = static_cast<int>((word >> bit_shift[i]) & 1);
      gain_[i][wanted_[i]] = 1;  // still unpainted, so wrong; the other colour leaves it wrong
      ++wrong_;
    }
  }

  int wrong() const { return wrong_; }

  /// The rectangle with the largest gain; of equals the first in the order y0, y1, x0, x1, colour.
  /// Rows y0..y1 are summed up column by column, so that each rectangle costs one addition.
  Rectangle best() {
    Rectangle best;
    for (int y0 = 0; y0 < side_; ++y0) {
      std::fill(column_.begin(), column_.end(), Gain{0, 0});
      for (int y1 = y0; y1 < side_; ++y1) {
        for (int x = 0; x < side_; ++x) add(column_[x], gain_[y1 * side_ + x]);
        best_in_rows(y0, y1, best);
      }
    }
    return best;
  }

  void paint(const Rectangle& r) {
    for (int y = r.y0; y <= r.y1; ++y) {
      for (int x = r.x0; x <= r.x1; ++x) {
        const std::size_t i = static_cast<std::size_t>(y) * side_ + x;
        if (wanted_[i] == kNoBit) continue;
        const int right = wanted_[i];
        // A right cell has nothing to gain and one to lose; a wrong one the other way round.
        gain_[i][right] = r.colour == right ? 0 : 1;
        gain_[i][1 - right] = r.colour == right ? -1 : 0;
      }
    }
    wrong_ -= r.gain;
  }

 private:
  using Gain = std::array<int, 2>;  // by colour

  static void add(Gain& sum, const Gain& gain) {
    sum[0] += gain[0];
    sum[1] += gain[1];
  }

  void best_in_rows(int y0, int y1, Rectangle& best) const {
    for (int x0 = 0; x0 < side_; ++x0) {
      Gain sum{0, 0};
      for (int x1 = x0; x1 < side_; ++x1) {
        add(sum, column_[x1]);
        for (const int colour : {0, 1}) {
          if (sum[colour] > best.gain) best = {x0, y0, x1, y1, colour, sum[colour]};
        }
      }
    }
  }

  int side_;
  int wrong_ = 0;
  std::vector<int> wanted_;
  std::vector<Gain> gain_;
  std::vector<Gain> column_;
};

}  // namespace

RectanglePainter::RectanglePainter(const Layout& layout) {
  // The layout looks the same after a quarter turn, so the data cells' bounding box is a square in
  // the middle of the tag.
  int offset = layout.width();
  for (const CellPosition p : layout.data_cells()) offset = std::min({offset, p.x, p.y});
  side_ = layout.width() - 2 * offset;
  bit_shift_.assign(static_cast<std::size_t>(side_) * side_, kNoBit);
  int shift = layout.bits();
  for (const CellPosition p : layout.data_cells()) {
    // Turned by 180 degrees: the published generator read its words from the other end.
    const int x = side_ - 1 - (p.x - offset);
    const int y = side_ - 1 - (p.y - offset);
    bit_shift_[static_cast<std::size_t>(y) * side_ + x] = --shift;
  }
}

int RectanglePainter::count(Codeword word, int stop_at) const {
  Canvas canvas(side_, bit_shift_, word);
  int rectangles = 0;
  while (canvas.wrong() > 0 && rectangles < stop_at) {
    canvas.paint(canvas.best());
    ++rectangles;
  }
  return rectangles;
}

}  // namespace tagmint::codec
