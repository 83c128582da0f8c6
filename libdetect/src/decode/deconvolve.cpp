#include "decode/deconvolve.h"

#include <algorithm>

namespace tagmint::detect {
namespace {

/// Length of a step; below 2 the steps settle.
constexpr double kStep = 1.5;

/// `cells` blurred by (share, 1 - 2 share, share) along both axes; the edge cells go on outside.
void blur_cells(const std::vector<float>& cells, int width, float share, std::vector<float>& rows,
                std::vector<float>& blurred) {
  rows.resize(cells.size());
  blurred.resize(cells.size());
  const float middle = 1 - 2 * share;
  for (int y = 0; y < width; ++y) {
    const float* from = cells.data() + y * width;
    float* to = rows.data() + y * width;
    for (int x = 1; x + 1 < width; ++x)
      to[x] = middle * from[x] + share * (from[x - 1] + from[x + 1]);
    const int last = width - 1;
    to[0] = (1 - share) * from[0] + share * from[std::min(1, last)];
    to[last] = (1 - share) * from[last] + share * from[std::max(0, last - 1)];
  }
  for (int y = 0; y < width; ++y) {
    const float* at = rows.data() + y * width;
    const float* up = rows.data() + std::max(0, y - 1) * width;
    const float* down = rows.data() + std::min(width - 1, y + 1) * width;
    float* to = blurred.data() + y * width;
    for (int x = 0; x < width; ++x) to[x] = middle * at[x] + share * (up[x] + down[x]);
  }
}

}  // namespace

void deconvolve(const CellGrid& grid, const Whiteness& read, double share,
                DeconvolveScratch& scratch, Whiteness& sharp) {
  // Rings beside each other gray each other, so that full black and white lie beyond what they
  // show.
  const auto full = static_cast<float>(1 + 2 * share);
  const int width = grid.geometry().width;
  sharp = read;
  const bool dark_inside = !grid.reversed();
  const std::vector<std::uint8_t>& known = sharp.known;
  std::vector<std::uint8_t>& fixed = scratch.fixed;
  fixed.assign(known.size(), 0);
  for (int which = 0; which < 2; ++which) {
    const bool dark = (which == 1) == dark_inside;
    for (const int cell : grid.ring(which)) {
      sharp.value[cell] = dark ? -full : full;
      fixed[cell] = 1;
    }
  }
  for (float& value : sharp.value) value = std::clamp(value, -full, full);
  // Cells that are fixed or not read take no steps.
  std::vector<float>& weight = scratch.weight;
  weight.resize(known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    weight[i] = fixed[i] != 0 || known[i] == 0 ? 0 : static_cast<float>(kStep);
  }
  for (int step = 0; step < kDeconvolutionSteps; ++step) {
    blur_cells(sharp.value, width, static_cast<float>(share), scratch.rows, scratch.blurred);
    for (std::size_t i = 0; i < known.size(); ++i) {
      const float moved = sharp.value[i] + weight[i] * (read.value[i] - scratch.blurred[i]);
      sharp.value[i] = std::min(full, std::max(-full, moved));
    }
  }
}

}  // namespace tagmint::detect
