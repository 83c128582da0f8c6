#include "cli/reading_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace tagmint::cli {
namespace {

struct Measured {
  double cell_px;
  CellReading reading;
};

// What tests/bench/reading_by_cell_size printed for one layout of each kind; shares of 576 tags.
// Where the tenths of a percent went up and down, the worse figure is taken for the smaller cell.

/// All cells inside the border square: classic:10.
constexpr std::array kInside = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.30}},     Measured{0.9, {0.523, 0.2335}},
    Measured{1.0, {0.594, 0.1633}}, Measured{1.1, {0.701, 0.1102}}, Measured{1.2, {0.859, 0.0588}},
    Measured{1.3, {0.950, 0.0155}}, Measured{1.4, {0.986, 0.0008}}, Measured{1.5, {1.0, 0.0}}};

/// Cells up to two outside the border square: standard:9.
constexpr std::array kTwoOutside = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.40}},     Measured{0.9, {0.160, 0.3378}},
    Measured{1.0, {0.295, 0.2575}}, Measured{1.1, {0.458, 0.1642}}, Measured{1.2, {0.679, 0.0858}},
    Measured{1.3, {0.863, 0.0441}}, Measured{1.4, {0.974, 0.0181}}, Measured{1.5, {1.0, 0.0100}},
    Measured{1.6, {1.0, 0.0032}},   Measured{1.8, {1.0, 0.0004}},   Measured{2.0, {1.0, 0.0001}},
    Measured{2.4, {1.0, 0.0}}};

/// Cells three and more outside the border square: circle:11.
constexpr std::array kFarOutside = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.45}},     Measured{0.9, {0.344, 0.3705}},
    Measured{1.0, {0.490, 0.2855}}, Measured{1.1, {0.693, 0.1933}}, Measured{1.2, {0.835, 0.1127}},
    Measured{1.3, {0.934, 0.0611}}, Measured{1.4, {0.991, 0.0212}}, Measured{1.5, {1.0, 0.0128}},
    Measured{1.6, {1.0, 0.0043}},   Measured{1.8, {1.0, 0.0004}},   Measured{2.0, {1.0, 0.0001}},
    Measured{2.4, {1.0, 0.0}}};

/// How many cells outside the border square the outermost data cell lies; 0 = none does.
int cells_outside(const codec::Layout& layout) {
  int ring = layout.width();
  for (const codec::CellPosition p : layout.data_cells()) ring = std::min({ring, p.x, p.y});
  return std::max(0, layout.border_offset() - ring);
}

std::span<const Measured> curve_of(const codec::Layout& layout) {
  const int outside = cells_outside(layout);
  if (outside == 0) return kInside;
  if (outside <= 2) return kTwoOutside;
  return kFarOutside;
}

/// P(at most `errors` of `bits` cells are wrong), each with probability `wrong`.
double binomial_share(int bits, int errors, double wrong) {
  if (wrong <= 0) return 1;
  double term = std::pow(1 - wrong, bits);  // P(exactly i wrong)
  double sum = term;
  for (int i = 1; i <= std::min(errors, bits); ++i) {
    term *= (bits - i + 1.0) / i * wrong / (1 - wrong);
    sum += term;
  }
  return std::min(sum, 1.0);
}

}  // namespace

CellReading cell_reading(const codec::Layout& layout, double cell_px) {
  const std::span<const Measured> curve = curve_of(layout);
  const auto above = std::find_if(curve.begin(), curve.end(),
                                  [&](const Measured& m) { return m.cell_px > cell_px; });
  if (above == curve.end()) return curve.back().reading;
  const Measured& high = *above;
  const Measured& low = *(above - 1);
  const double part = (cell_px - low.cell_px) / (high.cell_px - low.cell_px);
  return {std::lerp(low.reading.border_found, high.reading.border_found, part),
          std::lerp(low.reading.wrong_cells, high.reading.wrong_cells, part)};
}

double share_found(const codec::Layout& layout, double cell_px, int max_errors) {
  const CellReading reading = cell_reading(layout, cell_px);
  return reading.border_found * binomial_share(layout.bits(), max_errors, reading.wrong_cells);
}

double cell_px_for_share(const codec::Layout& layout, int max_errors, double share) {
  double low = 0;
  double high = curve_of(layout).back().cell_px;
  while (high - low > 0.0005) {
    const double middle = (low + high) / 2;
    (share_found(layout, middle, max_errors) < share ? low : high) = middle;
  }
  return high;
}

}  // namespace tagmint::cli
