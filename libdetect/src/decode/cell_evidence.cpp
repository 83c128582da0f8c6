#include "decode/cell_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tagmint/codec/family_stats.h"

namespace tagmint::detect {
namespace {

using codec::Cell;
using codec::CellPosition;

/// Deviation of cells from their model where the tag is there, beside that of the rings: print,
/// samples beside the middle, blur that differs from the model's.
constexpr double kOwnScatter = 0.15;
/// Deviation where it is not there.
constexpr double kOtherScatter = 0.55;
/// Share of cells that something covers, and density of their values over black .. white and half
/// as much again.
constexpr double kCovered = 0.03;
constexpr double kCoveredDensity = 0.25;
/// Most that a neighbour gives.
constexpr double kMostBlur = 0.35;
/// Quads with a border's rings that hold no tag, for each that holds one, as a logarithm: 100.
constexpr double kOtherQuads = 4.6;

double normal_density(double x, double deviation) {
  const double t = x / deviation;
  return std::exp(-t * t / 2) / (deviation * std::sqrt(2 * std::numbers::pi));
}

/// Sums of a regression of value on own colour and the differences to the neighbours' colours.
struct Sums {
  double cc = 0, cn = 0, nn = 0, cv = 0, nv = 0;
};

}  // namespace

double cell_evidence(const codec::Layout& layout, const Whiteness& cells, codec::Codeword word,
                     const Print& print, double scatter, std::vector<std::int8_t>& colour) {
  constexpr std::array<CellPosition, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const int width = layout.width();
  // Colour of each cell as it is seen: 1, -1, or 0 where nothing is known.
  colour.assign(static_cast<std::size_t>(width) * width, 0);
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cell cell = layout.cell(x, y);
      if (cell != Cell::Black && cell != Cell::White) continue;
      const bool white = (cell == Cell::White) != print.inverted;
      colour[seen_at(layout, {x, y}, print)] = white ? 1 : -1;
    }
  }
  int bit = layout.bits();
  for (const CellPosition p : layout.data_cells()) {
    const bool white = (((word >> --bit) & 1) != 0) != print.inverted;
    colour[seen_at(layout, p, print)] = white ? 1 : -1;
  }
  const auto neighbours = [&](int i) {
    double sum = 0;
    for (const CellPosition step : kSteps) {
      const int x = i % width + step.x;
      const int y = i / width + step.y;
      if (x < 0 || y < 0 || x >= width || y >= width || colour[y * width + x] == 0) continue;
      sum += colour[y * width + x] - colour[i];
    }
    return sum;
  };

  Sums s;
  for (const CellPosition p : layout.data_cells()) {
    const int i = seen_at(layout, p, print);
    const double c = colour[i];
    const double n = neighbours(i);
    const double v = cells.value[i];
    if (c * v < 0) continue;  // a corrected error says nothing of light and blur
    s.cc += c * c;
    s.cn += c * n;
    s.nn += n * n;
    s.cv += c * v;
    s.nv += n * v;
  }
  if (!(s.cc > 0)) return -kMostDoubt;
  const double determinant = s.cc * s.nn - s.cn * s.cn;
  double own = s.cv / s.cc;
  double blur = 0;
  if (determinant > 1e-9 * s.cc * s.cc) {
    blur = (s.cc * s.nv - s.cn * s.cv) / determinant;
    own = (s.nn * s.cv - s.cn * s.nv) / determinant;
    const double limited = std::clamp(blur, 0.0, std::max(0.0, kMostBlur * own));
    if (limited != blur) {
      blur = limited;
      own = (s.cv - blur * s.cn) / s.cc;
    }
  }
  const double deviation = std::hypot(kOwnScatter, scatter);
  double evidence = 0;
  for (const CellPosition p : layout.data_cells()) {
    const int i = seen_at(layout, p, print);
    const double off = cells.value[i] - own * colour[i] - blur * neighbours(i);
    const double here =
        (1 - kCovered) * normal_density(off, deviation) + kCovered * kCoveredDensity;
    const double not_here =
        (1 - kCovered) * normal_density(off, kOtherScatter) + kCovered * kCoveredDensity;
    evidence += std::log(here / not_here);
  }
  return std::max(-kMostDoubt, evidence);
}

double log_odds(const codec::Family& family, int hamming, double evidence, int tries) {
  const double accident = codec::false_accept_rate(family.size(), family.bits(), hamming);
  return evidence - std::log(accident * tries) - kOtherQuads;
}

}  // namespace tagmint::detect
