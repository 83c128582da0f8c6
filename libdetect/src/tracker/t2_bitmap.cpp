#include "tracker/t2_bitmap.h"

#include <algorithm>
#include <cassert>

namespace tagmint::detect {
namespace {

/// Three rows of tiles in turns; row r is in place r modulo 3.
class RollingTiles {
 public:
  RollingTiles(ImageView image, BitmapScratch& scratch)
      : image_(image),
        stride_((static_cast<std::size_t>(image.width) + 4 * kTileRowPadding - 1) /
                kTileRowPadding * kTileRowPadding) {
    scratch.bytes.resize(6 * stride_);
    bytes_ = scratch.bytes.data();
  }

  int tile_rows() const { return (image_.height + kTile - 1) / kTile; }

  /// The pixels of a row of tiles; the last row of the picture stands for those missing.
  PixelRows pixels(int tile_row) const {
    PixelRows rows;
    for (int i = 0; i < kTile; ++i) {
      rows[static_cast<std::size_t>(i)] =
          image_.row(std::min(tile_row * kTile + i, image_.height - 1));
    }
    return rows;
  }

  void compute(int tile_row) {
    tile_extrema(pixels(tile_row), image_.width, place(tile_row), place(tile_row) + stride_);
  }

  /// A row beyond the picture's edge is the one at the edge.
  TileRow at(int tile_row) {
    const int clamped = std::clamp(tile_row, 0, tile_rows() - 1);
    return {place(clamped), place(clamped) + stride_};
  }

 private:
  std::uint8_t* place(int tile_row) {
    return bytes_ + static_cast<std::size_t>(tile_row % 3) * 2 * stride_ + kTileRowPadding;
  }

  ImageView image_;
  std::size_t stride_;
  std::uint8_t* bytes_ = nullptr;
};

}  // namespace

void threshold_rows(ImageView image, int first, int end, ContrastRule rule, BitmapScratch& scratch,
                    BitPlane& black, BitPlane* white) {
  assert(first % kTile == 0);
  RollingTiles tiles(image, scratch);
  const int begin_tile = first / kTile;
  const int end_tile = (end + kTile - 1) / kTile;
  if (begin_tile > 0) tiles.compute(begin_tile - 1);
  tiles.compute(begin_tile);
  for (int tile = begin_tile; tile < end_tile; ++tile) {
    if (tile + 1 < tiles.tile_rows()) tiles.compute(tile + 1);
    BitRows black_rows{};
    BitRows white_rows{};
    for (int i = 0; i < kTile && tile * kTile + i < end; ++i) {
      black_rows[static_cast<std::size_t>(i)] = black.row(tile * kTile + i);
      if (white) white_rows[static_cast<std::size_t>(i)] = white->row(tile * kTile + i);
    }
    threshold_tiles(tiles.pixels(tile), image.width, tiles.at(tile - 1), tiles.at(tile),
                    tiles.at(tile + 1), rule, black_rows, white_rows);
  }
}

}  // namespace tagmint::detect
