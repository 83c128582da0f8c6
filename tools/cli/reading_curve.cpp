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

/// All cells inside a border square of up to six cells: classic:8.
constexpr std::array kInsideSix = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.30}},     Measured{0.9, {0.042, 0.0677}},
    Measured{1.0, {0.085, 0.0327}}, Measured{1.1, {0.113, 0.0327}}, Measured{1.2, {0.238, 0.0219}},
    Measured{1.3, {0.571, 0.0089}}, Measured{1.4, {0.865, 0.0004}}, Measured{1.5, {0.981, 0.0}},
    Measured{1.6, {0.993, 0.0}},    Measured{1.8, {0.998, 0.0}},    Measured{2.0, {1.0, 0.0}}};

/// Inside one of seven: classic:9.
constexpr std::array kInsideSeven = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.30}},     Measured{0.9, {0.062, 0.1556}},
    Measured{1.0, {0.135, 0.0949}}, Measured{1.1, {0.278, 0.069}},  Measured{1.2, {0.616, 0.0368}},
    Measured{1.3, {0.939, 0.0147}}, Measured{1.4, {0.986, 0.0008}}, Measured{1.5, {0.997, 0.0001}},
    Measured{1.6, {0.997, 0.0}},    Measured{1.8, {0.997, 0.0}},    Measured{2.0, {0.998, 0.0}},
    Measured{2.4, {0.998, 0.0}},    Measured{3.0, {1.0, 0.0}}};

/// Inside one of eight and more: classic:10.
constexpr std::array kInside = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.30}},     Measured{0.9, {0.057, 0.1599}},
    Measured{1.0, {0.241, 0.0887}}, Measured{1.1, {0.667, 0.0833}}, Measured{1.2, {0.929, 0.0521}},
    Measured{1.3, {0.993, 0.0156}}, Measured{1.4, {0.997, 0.0008}}, Measured{1.5, {0.997, 0.0}},
    Measured{1.6, {0.997, 0.0}},    Measured{1.8, {0.998, 0.0}},    Measured{2.0, {0.998, 0.0}},
    Measured{2.4, {1.0, 0.0}}};

/// Cells up to two outside the border square: standard:9.
constexpr std::array kTwoOutside = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.40}},     Measured{0.9, {0.012, 0.3275}},
    Measured{1.0, {0.102, 0.1687}}, Measured{1.1, {0.201, 0.1085}}, Measured{1.2, {0.517, 0.0662}},
    Measured{1.3, {0.819, 0.0391}}, Measured{1.4, {0.924, 0.0219}}, Measured{1.5, {0.955, 0.0093}},
    Measured{1.6, {0.988, 0.0033}}, Measured{1.8, {0.988, 0.0006}}, Measured{2.0, {0.99, 0.0002}},
    Measured{2.4, {0.997, 0.0}},    Measured{3.0, {1.0, 0.0}}};

/// Cells three and more outside the border square: circle:11.
constexpr std::array kFarOutside = {
    Measured{0.0, {0.0, 0.5}},      Measured{0.8, {0.0, 0.45}},     Measured{0.9, {0.017, 0.3449}},
    Measured{1.0, {0.094, 0.2298}}, Measured{1.1, {0.28, 0.1506}},  Measured{1.2, {0.618, 0.105}},
    Measured{1.3, {0.882, 0.0643}}, Measured{1.4, {0.948, 0.0327}}, Measured{1.5, {0.965, 0.0177}},
    Measured{1.6, {0.984, 0.0062}}, Measured{1.8, {0.988, 0.0014}}, Measured{2.0, {0.988, 0.0002}},
    Measured{2.4, {0.988, 0.0}},    Measured{3.0, {1.0, 0.0}}};

/// How many cells outside the border square the outermost data cell lies; 0 = none does.
int cells_outside(const codec::Layout& layout) {
  int ring = layout.width();
  for (const codec::CellPosition p : layout.data_cells()) ring = std::min({ring, p.x, p.y});
  return std::max(0, layout.border_offset() - ring);
}

std::span<const Measured> curve_of(const codec::Layout& layout) {
  const int outside = cells_outside(layout);
  if (outside == 0) {
    if (layout.width_at_border() <= 6) return kInsideSix;
    return layout.width_at_border() == 7 ? std::span<const Measured>(kInsideSeven) : kInside;
  }
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
