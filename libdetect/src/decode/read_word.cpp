#include "decode/read_word.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tagmint::detect {
namespace {

using codec::Cell;
using codec::CellPosition;
using codec::Layout;

/// Gray levels that a camera gives to black in any light; the geometric mean needs it above zero.
constexpr double kLeastBlack = 4;
/// White must be so many times as bright as black for shadows to be told from ink.
constexpr double kLeastRatio = 2.5;

bool take(const CellGrid& grid, const Layout& layout, Whiteness& cells,
          const auto& value_and_levels) {
  const int width = layout.width();
  const auto size = static_cast<std::size_t>(width) * width;
  cells.value.assign(size, 0);
  cells.known.assign(size, 0);
  cells.gray_levels.assign(size, 0);
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cell cell = layout.cell(x, y);
      if (cell == Cell::None) continue;
      const int i = y * width + x;
      if (!grid.is_read(i)) {
        if (cell == Cell::Data) return false;
        continue;
      }
      const auto [value, levels] = value_and_levels(i);
      cells.value[i] = static_cast<float>(value);
      cells.gray_levels[i] = static_cast<float>(levels);
      cells.known[i] = 1;
    }
  }
  return true;
}

/// Gray value below which `share` of a ring's cells lie.
double quantile_of_ring(const CellGrid& grid, int which, double share, std::vector<double>& grays) {
  grays.clear();
  for (const int cell : grid.ring(which)) {
    if (grid.is_read(cell)) grays.push_back(grid.gray(cell));
  }
  const auto at =
      grays.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(grays.size() - 1));
  std::nth_element(grays.begin(), at, grays.end());
  return *at;
}

}  // namespace

bool whiteness_by_planes(const CellGrid& grid, const Layout& layout, Whiteness& cells) {
  return take(grid, layout, cells, [&](int i) {
    // Where light falls off so fast that the planes cross, the middle's contrast stands in.
    const double half = grid.half_contrast(i) > 0 ? grid.half_contrast(i) : grid.contrast() / 2;
    return std::pair((grid.gray(i) - grid.threshold(i)) / half, half);
  });
}

bool whiteness_in_shadow(const CellGrid& grid, const Layout& layout, std::vector<double>& sorted,
                         Whiteness& cells) {
  const int dark_ring = grid.reversed() ? 0 : 1;
  const double black = std::max(kLeastBlack, quantile_of_ring(grid, dark_ring, 0.5, sorted));
  const double white = quantile_of_ring(grid, 1 - dark_ring, 0.8, sorted);
  if (!(white > kLeastRatio * black)) return false;
  const double middle = std::sqrt(black * white);
  const double span = std::log(white / black) / 2;
  return take(grid, layout, cells, [&](int i) {
    const double value = std::log(std::max(kLeastBlack, grid.gray(i)) / middle) / span;
    return std::pair(std::clamp(value, -1.5, 1.5), (white - black) / 2);
  });
}

Reading read_word(const Layout& layout, const Whiteness& cells, double sharpening,
                  const Print& print) {
  constexpr std::array<CellPosition, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const int width = layout.width();
  Reading reading;
  double white_sum = 0, black_sum = 0;
  int whites = 0, blacks = 0;
  for (const CellPosition p : layout.data_cells()) {
    const int i = seen_at(layout, p, print);
    // Raised against its neighbours to undo blur across the cell's edges.
    double laplacian = 0;
    for (const CellPosition step : kSteps) {
      const int x = i % width + step.x;
      const int y = i / width + step.y;
      if (x < 0 || y < 0 || x >= width || y >= width || cells.known[y * width + x] == 0) continue;
      laplacian += cells.value[i] - cells.value[y * width + x];
    }
    const double value = cells.value[i] + sharpening * laplacian;
    const bool white = (value > 0) != print.inverted;
    reading.word = (reading.word << 1) | static_cast<codec::Codeword>(white);
    (white ? white_sum : black_sum) += std::abs(value) * cells.gray_levels[i];
    ++(white ? whites : blacks);
  }
  // A colour that does not occur cannot be unclear.
  const double white_mean = whites > 0 ? white_sum / whites : black_sum / blacks;
  const double black_mean = blacks > 0 ? black_sum / blacks : white_mean;
  reading.decision_margin = std::min(white_mean, black_mean);
  return reading;
}

}  // namespace tagmint::detect
