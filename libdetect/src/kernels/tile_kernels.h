#pragma once

#include <array>
#include <cstdint>

namespace tagmint::detect {

/// Side of a tile, px.
inline constexpr int kTile = 4;
/// Bytes that may be read and written before and behind a row of extrema.
inline constexpr int kTileRowPadding = 64;

/// Four rows of pixels; at the lower edge of the picture the last one may stand for those missing.
using PixelRows = std::array<const std::uint8_t*, kTile>;

/// The extrema of a row of tiles, at each pixel those of its tile, so that no step from tiles to
/// pixels is needed later. kTileRowPadding bytes lie before and behind.
struct TileRow {
  const std::uint8_t* low = nullptr;
  const std::uint8_t* high = nullptr;
};

/// Where black ends, by the contrast high - low, gray levels: below `floor` nothing is black or
/// white; up to `middle_up_to` the threshold is half-way from low to high, above a quarter of the
/// way.
struct ContrastRule {
  std::uint8_t floor = 5;
  std::uint8_t middle_up_to = 255;
};

/// Four rows of bits to write; null where a row is not wanted.
using BitRows = std::array<std::uint64_t*, kTile>;

/// Extrema of each tile of four rows, and copies of the outermost tiles beyond both ends.
///   low, high   get ceil(width / 4) * 4 values and kTile more on both sides
///   cost        a pass over the pixels, a vector at a time
void tile_extrema(const PixelRows& rows, int width, std::uint8_t* low, std::uint8_t* high);

/// Black and white of four rows of pixels. With low and high the extrema over 3 x 3 tiles, a pixel
/// is black below middle = (low + high + 1) / 2, or below (low + middle + 1) / 2 where the contrast
/// is large, and white otherwise; it is neither where the contrast is below the floor.
///   above, here, below   extrema of the three rows of tiles
///   black, white         get whole vectors of bits, zero beyond the width
///   cost                 a pass over the pixels, a vector at a time; none over those without
///   contrast
void threshold_tiles(const PixelRows& rows, int width, const TileRow& above, const TileRow& here,
                     const TileRow& below, ContrastRule rule, const BitRows& black,
                     const BitRows& white);

namespace scalar {

/// The same, a pixel at a time.
void tile_extrema(const PixelRows& rows, int width, std::uint8_t* low, std::uint8_t* high);
void threshold_tiles(const PixelRows& rows, int width, const TileRow& above, const TileRow& here,
                     const TileRow& below, ContrastRule rule, const BitRows& black,
                     const BitRows& white);

}  // namespace scalar

}  // namespace tagmint::detect
