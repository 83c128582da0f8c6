#pragma once

#include <cstdint>
#include <vector>

#include "tagmint/codec/family.h"

namespace tagmint::detect {

/// Grid lines in each direction whose edges can reach into a pixel: the nearest one where cells are
/// wide against the point-spread, those of the pixel's own cell, or those of the neighbouring cells
/// too where cells are small.
inline constexpr int kWideCells = 1, kMiddlingCells = 2, kSmallCells = 4;

/// Numbers of a pixel's surroundings are packed eight to a word.
inline constexpr int kCodesPerWord = 8;
constexpr int words_for_edges(int edges) {
  return ((edges + 1) * (edges + 1) + kCodesPerWord - 1) / kCodesPerWord;
}
inline constexpr int kMaxPatternWords = words_for_edges(kSmallCells);

/// What the tag's picture is around a place, ready to be mixed.
///
/// With brightness c(i, j) of the cells around (0 black, 2 white, 1 half) the picture at a place is
/// the sum of M(a, b) P_a(u) P_b(v), where P_0 = 1, P_a is the edge profile across the a-th grid
/// line from the left (or top) of the surroundings and M holds the mixed differences of c: M(0,0) =
/// c of the top left cell, M(a,0) = its differences along x, M(0,b) along y, and M(a,b) both.
struct CellSurroundings {
  /// M by edges: code a + b (edges + 1) is signed, of four bits, from the least bits up.
  std::uint32_t words[kMaxPatternWords] = {};
};

/// The grid of a tag with the colours of all cells that are known, and what lies around each place.
class TagPattern {
 public:
  /// Takes the cells of a tag, upright. Cells without a colour of their own, inside the grid and
  /// around it, are half bright until guess() says more. As printed: with black for white, left for
  /// right, or both.
  void begin(const codec::Family& family, codec::TagId id, bool inverted = false,
             bool mirrored = false);
  /// What a cell that is not known seems to be: twice its brightness, 0..2. -1 <= x, y <= width();
  /// those farther outside are like the nearest of these.
  void guess(int x, int y, int brightness) {
    brightness_[padded(x, y)] = static_cast<std::int8_t>(brightness);
  }
  /// Works out the surroundings.
  ///   edges   kWideCells, kMiddlingCells or kSmallCells
  void finish(int edges);

  int edges() const { return edges_; }
  /// Side of the tag in cells.
  int width() const { return width_; }
  /// The border square in cells from the tag's outer edge: [border_begin, border_end] both ways.
  int border_begin() const { return border_begin_; }
  int border_end() const { return border_end_; }

  /// The first of the grid lines that count for a place in a cell, one way: line k is the left (or
  /// top) side of cell k.
  ///   place   in cells, inside cell `cell`
  int first_line(double place, int cell) const {
    if (edges_ == kWideCells) return place - cell < 0.5 ? cell : cell + 1;
    return edges_ == kMiddlingCells ? cell : cell - 1;
  }
  /// What lies around the place with these first lines.
  const CellSurroundings& surroundings(int first_x, int first_y) const {
    return surroundings_[(first_y + 1) * (width_ + 2) + first_x + 1];
  }

  /// Whether the outermost cells are known and of one colour, so that no edge is nearer to the
  /// tag's outside than one cell.
  bool plain_rim() const;

  /// 0 <= x, y < width(): row-major index of a cell.
  int index(int x, int y) const { return y * width_ + x; }
  /// Bits of kChange* and kUnknown* of all cells.
  const std::vector<std::int32_t>& flags() const { return flags_; }

  /// Twice the brightness of a cell, guessed where it is not known; -1 <= x, y <= width().
  int brightness(int x, int y) const { return brightness_[padded(x, y)]; }
  /// Whether the tag says what colour the cell has; the same x, y.
  bool is_known(int x, int y) const { return known_[padded(x, y)] != 0; }

  /// The colour changes across this side of the cell, and both sides of it are known.
  static constexpr std::int32_t kChangeLeft = 1, kChangeRight = 2, kChangeUp = 4, kChangeDown = 8;
  /// A cell beyond this side, straight or diagonally, is not known.
  static constexpr std::int32_t kUnknownLeft = 16, kUnknownRight = 32, kUnknownUp = 64,
                                kUnknownDown = 128;
  /// The cell itself is known.
  static constexpr std::int32_t kKnown = 256;

 private:
  static constexpr int kPad = 3;  // cells around the tag that surroundings can reach

  int padded(int x, int y) const { return (y + kPad) * (width_ + 2 * kPad) + x + kPad; }
  void extend_guesses();
  void take_differences();
  template <int kEdges>
  void fill_surroundings();
  std::int32_t flags_of(int x, int y) const;

  int edges_ = kMiddlingCells;
  int width_ = 0;
  int border_begin_ = 0;
  int border_end_ = 0;
  std::vector<std::int8_t> brightness_;  // with kPad cells around the tag
  std::vector<std::int8_t> known_;       // alike
  /// Brightness, its differences along x, along y and along both: low four bits, padded alike.
  std::vector<std::uint32_t> code_, code_x_, code_y_, code_xy_;
  std::vector<CellSurroundings> surroundings_;
  std::vector<std::int32_t> flags_;
};

}  // namespace tagmint::detect
