#pragma once

#include <cstdint>
#include <vector>

#include "tagmint/detect/image.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage 2: the working image -> black, white and unknown pixels [WangOlson2016, section III-B].
struct ThresholdOptions {
  /// Gray levels, 0..255. Where the 3x3 neighbourhood of a tile spreads over fewer, its pixels
  /// become kUnknown and cost nothing from here on.
  int min_contrast = 5;
};

/// Side of a threshold tile, px [WangOlson2016, section III-B].
inline constexpr int kTileSide = 4;

/// Buffers that threshold() keeps from one image to the next: extrema of every tile, row-major.
struct ThresholdScratch {
  std::vector<std::uint8_t> tile_min, tile_max;  ///< of the tile's own pixels
  std::vector<std::uint8_t> row_min, row_max;    ///< of the tile and its two row neighbours
  std::vector<std::uint8_t> threshold;           ///< one tile row, a value for each pixel
  std::vector<std::uint8_t> known;               ///< 255 where there is contrast, else 0
  std::vector<std::uint8_t> rolling;             ///< extrema of three rows of tiles, by pixel
};

/// Compares each pixel with the mean of the extrema of the 3x3 tiles around its own: above is
/// kWhite, the rest is kBlack, low contrast is kUnknown. Sides that are no multiple of 4 end in
/// smaller tiles, so that every pixel is judged alike.
///   working        any size
///   three_valued   takes the result, same size
///   cost           two passes over the pixels, a vector at a time
void threshold(ImageView working, const ThresholdOptions& options, ThresholdScratch& scratch,
               Image& three_valued);

namespace scalar {

/// The same tile by tile and pixel by pixel.
void threshold(ImageView working, const ThresholdOptions& options, ThresholdScratch& scratch,
               Image& three_valued);

}  // namespace scalar

}  // namespace tagmint::detect
