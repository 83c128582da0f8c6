#pragma once

#include <array>
#include <cstdint>

#include "kernels/tile_kernels.h"

namespace tagmint::detect {

/// Rows to write, as many as the tiles have; null where there is none.
using ByteRows = std::array<std::uint8_t*, kTile>;

/// Black, white and unknown of four rows of pixels. With low and high the extrema over 3 x 3 tiles,
/// a pixel is 255 above (low + high) / 2 and 0 otherwise, and 127 where high - low < floor.
///   above, here, below   extrema of the three rows of tiles, as tile_extrema() makes them
///   out                  get `width` values each
///   cost                 a pass over the pixels, a vector at a time
void three_values(const PixelRows& rows, int width, const TileRow& above, const TileRow& here,
                  const TileRow& below, std::uint8_t floor, const ByteRows& out);

namespace scalar {

/// The same for pixels from `begin` on, one at a time.
void three_values(const PixelRows& rows, int begin, int width, const TileRow& above,
                  const TileRow& here, const TileRow& below, std::uint8_t floor,
                  const ByteRows& out);

}  // namespace scalar

}  // namespace tagmint::detect
