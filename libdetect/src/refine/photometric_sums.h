#pragma once

#include <cstddef>

#include "refine/photometric_model.h"
#include "refine/photometric_pixels.h"

namespace tagmint::detect {

/// The normal equations of a Gauss-Newton step, from weighted pixels.
struct PhotometricSums {
  /// Sum of w J^T J; the upper triangle holds, row <= column.
  std::array<std::array<double, kPhotometricParameters>, kPhotometricParameters> normal{};
  PhotometricVector gradient{};  ///< sum of w J^T r with r = pixel less prediction
  double squared = 0;            ///< sum of w r^2
  double weight = 0;             ///< sum of w
};

/// What is summed.
struct PhotometricPass {
  /// Pixels far from their prediction count less: w = weight / (1 + (r / outlier_scale)^2). Gray
  /// levels, > 0.
  double outlier_scale = 1e9;
  std::size_t first_block = 0;
  std::size_t block_step = 1;  ///< every so many blocks
  bool normal = true;          ///< whether `normal` is wanted; else it stays zero
};

/// Sums over pixels, with the vectors of the machine; the same bits with all of them.
///   edges   of the pattern that the pixels' words are from
///   cost    docs/refinement.md
PhotometricSums photometric_sums(const PhotometricPixels& pixels,
                                 const PhotometricParameters& parameters, int edges,
                                 const PhotometricPass& pass);

namespace scalar {

/// The same from predict(), the plain reference; equal to rounding.
PhotometricSums photometric_sums(const PhotometricPixels& pixels, const TagPattern& pattern,
                                 const PhotometricParameters& parameters,
                                 const PhotometricPass& pass);

}  // namespace scalar
}  // namespace tagmint::detect
