#pragma once

#include <array>

#include "decode/read_word.h"

namespace tagmint::detect {

/// Shares of a cell's gray value that come from each of its neighbours along one axis, for which
/// blurred quads are tried: point-spreads of 0.4, 0.5, 0.65 and 0.85 of a cell.
inline constexpr std::array<double, 4> kBlurShares = {0.10, 0.16, 0.22, 0.28};

/// Buffers kept from one quad to the next.
struct DeconvolveScratch {
  std::vector<std::uint8_t> fixed;
  std::vector<float> rows, blurred, weight;
};

/// Takes blur out of the cells of a tag, of which the rings at the border square are known: cells
/// of value +-1 blurred by (share, 1 - 2 share, share) along both axes are to give what was read.
/// Steps against the difference, each cell held between black and white [VanCittert1931].
///   read    cells of the quad
///   share   below 1/2
///   sharp   takes the cells without blur, known rings at their colours
///   cost    kDeconvolutionSteps passes over the cells
void deconvolve(const CellGrid& grid, const Whiteness& read, double share,
                DeconvolveScratch& scratch, Whiteness& sharp);

inline constexpr int kDeconvolutionSteps = 14;

}  // namespace tagmint::detect
