#include "pipeline/s2_threshold.h"

#include <algorithm>

#include "kernels/three_value_kernels.h"
#include "pipeline/stage_types.h"

namespace tagmint::detect {
namespace {

int tiles_along(int side) { return (side + kTileSide - 1) / kTileSide; }

/// Extrema of the pixels of each tile. Four rows are first reduced column by column, contiguous in
/// memory, then four columns at a time. `threshold` and `known` lend the row of column extrema.
void find_tile_extrema(ImageView image, ThresholdScratch& s) {
  const int tiles_x = tiles_along(image.width), tiles_y = tiles_along(image.height);
  s.tile_min.resize(std::size_t(tiles_x) * tiles_y);
  s.tile_max.resize(s.tile_min.size());
  std::uint8_t* column_min = s.threshold.data();
  std::uint8_t* column_max = s.known.data();
  for (int ty = 0; ty < tiles_y; ++ty) {
    const int y_end = std::min(image.height, (ty + 1) * kTileSide);
    std::copy_n(image.row(ty * kTileSide), image.width, column_min);
    std::copy_n(image.row(ty * kTileSide), image.width, column_max);
    for (int y = ty * kTileSide + 1; y < y_end; ++y) {
      const std::uint8_t* row = image.row(y);
      for (int x = 0; x < image.width; ++x) {
        column_min[x] = std::min(column_min[x], row[x]);
        column_max[x] = std::max(column_max[x], row[x]);
      }
    }
    std::uint8_t* tile_min = s.tile_min.data() + std::size_t(ty) * tiles_x;
    std::uint8_t* tile_max = s.tile_max.data() + std::size_t(ty) * tiles_x;
    for (int tx = 0; tx < tiles_x; ++tx) {
      const int x_end = std::min(image.width, (tx + 1) * kTileSide);
      std::uint8_t low = 255, high = 0;
      for (int x = tx * kTileSide; x < x_end; ++x) {
        low = std::min(low, column_min[x]);
        high = std::max(high, column_max[x]);
      }
      tile_min[tx] = low;
      tile_max[tx] = high;
    }
  }
}

/// Extrema of each tile and its neighbours left and right.
void spread_along_rows(int tiles_x, int tiles_y, ThresholdScratch& s) {
  s.row_min.resize(s.tile_min.size());
  s.row_max.resize(s.tile_min.size());
  for (int ty = 0; ty < tiles_y; ++ty) {
    const std::size_t first = std::size_t(ty) * tiles_x;
    for (int tx = 0; tx < tiles_x; ++tx) {
      const std::size_t left = first + std::max(tx - 1, 0);
      const std::size_t right = first + std::min(tx + 1, tiles_x - 1);
      s.row_min[first + tx] =
          std::min({s.tile_min[left], s.tile_min[first + tx], s.tile_min[right]});
      s.row_max[first + tx] =
          std::max({s.tile_max[left], s.tile_max[first + tx], s.tile_max[right]});
    }
  }
}

/// Fills s.threshold and s.known for the pixels of tile row `ty`.
void prepare_tile_row(int ty, int width, int tiles_x, int tiles_y, int min_contrast,
                      ThresholdScratch& s) {
  const std::size_t above = std::size_t(std::max(ty - 1, 0)) * tiles_x;
  const std::size_t here = std::size_t(ty) * tiles_x;
  const std::size_t below = std::size_t(std::min(ty + 1, tiles_y - 1)) * tiles_x;
  for (int tx = 0; tx < tiles_x; ++tx) {
    const int low = std::min({s.row_min[above + tx], s.row_min[here + tx], s.row_min[below + tx]});
    const int high = std::max({s.row_max[above + tx], s.row_max[here + tx], s.row_max[below + tx]});
    // A pixel is white above (high + low) / 2; rounding down keeps `>` exact for whole numbers.
    const auto level = static_cast<std::uint8_t>((high + low) / 2);
    const std::uint8_t known = high - low < min_contrast ? 0 : 255;
    const int begin = tx * kTileSide;
    const int count = std::min(kTileSide, width - begin);
    std::fill_n(s.threshold.data() + begin, count, level);
    std::fill_n(s.known.data() + begin, count, known);
  }
}

/// The extrema of three rows of tiles at a time, each at all pixels of its tile.
class RollingTiles {
 public:
  RollingTiles(ImageView image, ThresholdScratch& scratch)
      : image_(image),
        tile_rows_(tiles_along(image.height)),
        pitch_(static_cast<std::size_t>(image.width) + 4 * kTileRowPadding) {
    scratch.rolling.resize(6 * pitch_);
    bytes_ = scratch.rolling.data();
  }

  /// The pixels of a row of tiles; the last row of the image stands for those missing.
  PixelRows pixels(int tile_row) const {
    PixelRows rows;
    for (int i = 0; i < kTile; ++i) {
      rows[static_cast<std::size_t>(i)] =
          image_.row(std::min(tile_row * kTile + i, image_.height - 1));
    }
    return rows;
  }
  /// Takes the place of the row three before.
  void compute(int tile_row) {
    if (tile_row >= tile_rows_) return;
    tile_extrema(pixels(tile_row), image_.width, low(tile_row), low(tile_row) + pitch_);
  }
  /// Beyond the image's edge goes on the row at the edge.
  TileRow at(int tile_row) const {
    const int clamped = std::clamp(tile_row, 0, tile_rows_ - 1);
    return {low(clamped), low(clamped) + pitch_};
  }

 private:
  std::uint8_t* low(int tile_row) const {
    return bytes_ + static_cast<std::size_t>(tile_row % 3) * 2 * pitch_ + kTileRowPadding;
  }

  ImageView image_;
  int tile_rows_;
  std::size_t pitch_;
  std::uint8_t* bytes_ = nullptr;
};

}  // namespace

void threshold(ImageView working, const ThresholdOptions& options, ThresholdScratch& scratch,
               Image& three_valued) {
  const int width = std::max(working.width, 0), height = std::max(working.height, 0);
  three_valued.resize(width, height);
  if (working.empty()) return;
  const auto floor = static_cast<std::uint8_t>(std::clamp(options.min_contrast, 0, 255));
  RollingTiles tiles(working, scratch);
  tiles.compute(0);
  for (int ty = 0; ty < tiles_along(height); ++ty) {
    tiles.compute(ty + 1);
    ByteRows out{};
    for (int i = 0; i < kTile && ty * kTile + i < height; ++i) {
      out[static_cast<std::size_t>(i)] = three_valued.row(ty * kTile + i);
    }
    three_values(tiles.pixels(ty), width, tiles.at(ty - 1), tiles.at(ty), tiles.at(ty + 1), floor,
                 out);
  }
}

void scalar::threshold(ImageView working, const ThresholdOptions& options,
                       ThresholdScratch& scratch, Image& three_valued) {
  const int width = std::max(working.width, 0), height = std::max(working.height, 0);
  three_valued.resize(width, height);
  if (working.empty()) return;
  const int tiles_x = tiles_along(width), tiles_y = tiles_along(height);
  scratch.threshold.resize(width);
  scratch.known.resize(width);
  find_tile_extrema(working, scratch);
  spread_along_rows(tiles_x, tiles_y, scratch);
  for (int ty = 0; ty < tiles_y; ++ty) {
    prepare_tile_row(ty, width, tiles_x, tiles_y, options.min_contrast, scratch);
    const std::uint8_t* level = scratch.threshold.data();
    const std::uint8_t* known = scratch.known.data();
    const int y_end = std::min(height, (ty + 1) * kTileSide);
    for (int y = ty * kTileSide; y < y_end; ++y) {
      const std::uint8_t* in = working.row(y);
      std::uint8_t* out = three_valued.row(y);
      for (int x = 0; x < width; ++x) {
        const std::uint8_t value = in[x] > level[x] ? kWhite : kBlack;
        out[x] = (value & known[x]) | (kUnknown & ~known[x]);
      }
    }
  }
}

}  // namespace tagmint::detect
