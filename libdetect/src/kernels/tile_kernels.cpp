#include "kernels/tile_kernels.h"

#include <algorithm>
#include <bit>
#include <cstring>

// Highway compiles this file once for each set of instructions.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/tile_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

// Vectors of one byte would not fill a byte of bits.
using scalar::threshold_tiles;
using scalar::tile_extrema;

#else

namespace hn = hwy::HWY_NAMESPACE;

// Rows of bits end on whole vectors of at most 512 bits.
using Bytes = hn::CappedTag<std::uint8_t, 64>;
using Quads = hn::Repartition<std::uint32_t, Bytes>;
using ByteVector = hn::Vec<Bytes>;

/// In each group of four bytes, all become f of the four.
template <typename Function>
HWY_ATTR ByteVector across_tile(ByteVector v, const Function& f) {
  const Bytes d;
  const Quads dq;
  const auto halves = f(v, hn::BitCast(d, hn::RotateRight<16>(hn::BitCast(dq, v))));
  return f(halves, hn::BitCast(d, hn::RotateRight<8>(hn::BitCast(dq, halves))));
}

struct Least {
  HWY_ATTR ByteVector operator()(ByteVector a, ByteVector b) const { return hn::Min(a, b); }
};
struct Most {
  HWY_ATTR ByteVector operator()(ByteVector a, ByteVector b) const { return hn::Max(a, b); }
};

/// Extrema at x, of four vectors of pixels.
HWY_ATTR void extrema_at(const PixelRows& rows, int from, int x, std::uint8_t* low,
                         std::uint8_t* high) {
  const Bytes d;
  const ByteVector a = hn::LoadU(d, rows[0] + from), b = hn::LoadU(d, rows[1] + from),
                   c = hn::LoadU(d, rows[2] + from), e = hn::LoadU(d, rows[3] + from);
  hn::StoreU(across_tile(hn::Min(hn::Min(a, b), hn::Min(c, e)), Least()), d, low + x);
  hn::StoreU(across_tile(hn::Max(hn::Max(a, b), hn::Max(c, e)), Most()), d, high + x);
}

/// The last pixels of four rows, each row's last one repeated to a whole vector.
struct RowEnds {
  std::array<std::array<std::uint8_t, 64>, kTile> pixels;
  PixelRows rows;

  RowEnds(const PixelRows& from, int begin, int end) {
    for (std::size_t i = 0; i < kTile; ++i) {
      const auto behind = std::copy(from[i] + begin, from[i] + end, pixels[i].begin());
      std::fill(behind, pixels[i].end(), from[i][end - 1]);
      rows[i] = pixels[i].data();
    }
  }
};

HWY_ATTR void tile_extrema(const PixelRows& rows, int width, std::uint8_t* low,
                           std::uint8_t* high) {
  const int lanes = static_cast<int>(hn::Lanes(Bytes()));
  int x = 0;
  for (; x + lanes <= width; x += lanes) extrema_at(rows, x, x, low, high);
  if (x < width) {
    const RowEnds ends(rows, x, width);
    extrema_at(ends.rows, 0, x, low, high);
  }
  const int end = (width + kTile - 1) / kTile * kTile;
  for (int i = 0; i < kTile; ++i) {
    low[i - kTile] = low[0];
    high[i - kTile] = high[0];
    low[end + i] = low[end - 1];
    high[end + i] = high[end - 1];
  }
}

/// f over the 3 x 3 tiles around the pixels from x on.
template <typename Function>
HWY_ATTR ByteVector neighbourhood(const std::uint8_t* above, const std::uint8_t* here,
                                  const std::uint8_t* below, int x, const Function& f) {
  const Bytes d;
  const auto column = [&](int at) HWY_ATTR {
    return f(f(hn::LoadU(d, above + at), hn::LoadU(d, here + at)), hn::LoadU(d, below + at));
  };
  return f(f(column(x - kTile), column(x)), column(x + kTile));
}

/// Writes the vectors of bits from x on.
template <bool kWhite>
HWY_ATTR void threshold_at(const PixelRows& rows, int from, int x, int pixels, const TileRow& above,
                           const TileRow& here, const TileRow& below, ContrastRule rule,
                           const BitRows& black, const BitRows& white) {
  const Bytes d;
  const auto bits_at = [x](std::uint64_t* row) {
    return reinterpret_cast<std::uint8_t*>(row) + x / 8;
  };
  const ByteVector low = neighbourhood(above.low, here.low, below.low, x, Least());
  const ByteVector high = neighbourhood(above.high, here.high, below.high, x, Most());
  const ByteVector contrast = hn::Sub(high, low);
  // Unsigned a >= b is max(a, b) == a.
  auto counts = hn::Eq(hn::Max(contrast, hn::Set(d, rule.floor)), contrast);
  if (pixels < static_cast<int>(hn::Lanes(d))) {
    counts = hn::And(counts, hn::FirstN(d, static_cast<std::size_t>(pixels)));
  }
  if (hn::AllFalse(d, counts)) {
    constexpr std::size_t kBytes = hn::MaxLanes(Bytes()) / 8;
    for (std::size_t i = 0; i < kTile; ++i) {
      if (black[i]) std::memset(bits_at(black[i]), 0, kBytes);
      if (kWhite && white[i]) std::memset(bits_at(white[i]), 0, kBytes);
    }
    return;
  }
  const ByteVector middle = hn::AverageRound(low, high);
  const auto moderate = hn::Eq(hn::Min(contrast, hn::Set(d, rule.middle_up_to)), contrast);
  const ByteVector threshold = hn::IfThenElse(moderate, middle, hn::AverageRound(low, middle));
  for (std::size_t i = 0; i < kTile; ++i) {
    const ByteVector pixel = hn::LoadU(d, rows[i] + from);
    const auto bright = hn::Eq(hn::Max(pixel, threshold), pixel);
    if (black[i]) hn::StoreMaskBits(d, hn::AndNot(bright, counts), bits_at(black[i]));
    if (kWhite && white[i]) hn::StoreMaskBits(d, hn::And(bright, counts), bits_at(white[i]));
  }
}

template <bool kWhite>
HWY_ATTR void threshold_row(const PixelRows& rows, int width, const TileRow& above,
                            const TileRow& here, const TileRow& below, ContrastRule rule,
                            const BitRows& black, const BitRows& white) {
  const int lanes = static_cast<int>(hn::Lanes(Bytes()));
  int x = 0;
  for (; x + lanes <= width; x += lanes) {
    threshold_at<kWhite>(rows, x, x, lanes, above, here, below, rule, black, white);
  }
  if (x < width) {
    const RowEnds ends(rows, x, width);
    threshold_at<kWhite>(ends.rows, 0, x, width - x, above, here, below, rule, black, white);
  }
}

HWY_ATTR void threshold_tiles(const PixelRows& rows, int width, const TileRow& above,
                              const TileRow& here, const TileRow& below, ContrastRule rule,
                              const BitRows& black, const BitRows& white) {
  const bool any_white = white != BitRows{};
  (any_white ? threshold_row<true> : threshold_row<false>)(rows, width, above, here, below, rule,
                                                           black, white);
}

#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {

void scalar::tile_extrema(const PixelRows& rows, int width, std::uint8_t* low, std::uint8_t* high) {
  const int tiles = (width + kTile - 1) / kTile;
  for (int tile = -1; tile <= tiles; ++tile) {
    const int begin = std::clamp(tile, 0, tiles - 1) * kTile;
    std::uint8_t least = 255;
    std::uint8_t most = 0;
    for (const std::uint8_t* row : rows) {
      for (int x = begin; x < std::min(begin + kTile, width); ++x) {
        least = std::min(least, row[x]);
        most = std::max(most, row[x]);
      }
    }
    std::fill_n(low + tile * kTile, kTile, least);
    std::fill_n(high + tile * kTile, kTile, most);
  }
}

void scalar::threshold_tiles(const PixelRows& rows, int width, const TileRow& above,
                             const TileRow& here, const TileRow& below, ContrastRule rule,
                             const BitRows& black, const BitRows& white) {
  for (std::size_t i = 0; i < kTile; ++i) {
    for (const BitRows* to : {&black, &white}) {
      if ((*to)[i]) std::fill_n((*to)[i], (width + 63) / 64, 0);
    }
  }
  for (int x = 0; x < width; ++x) {
    std::uint8_t low = 255;
    std::uint8_t high = 0;
    for (const TileRow* row : {&above, &here, &below}) {
      for (const int at : {x - kTile, x, x + kTile}) {
        low = std::min(low, row->low[at]);
        high = std::max(high, row->high[at]);
      }
    }
    if (high - low < rule.floor) continue;
    const int middle = (low + high + 1) / 2;
    const int threshold = high - low <= rule.middle_up_to ? middle : (low + middle + 1) / 2;
    for (std::size_t i = 0; i < kTile; ++i) {
      const bool is_black = rows[i][x] < threshold;
      std::uint64_t* to = is_black ? black[i] : white[i];
      if (to) to[x / 64] |= std::uint64_t{1} << (x % 64);
    }
  }
}

HWY_EXPORT(tile_extrema);
HWY_EXPORT(threshold_tiles);

void tile_extrema(const PixelRows& rows, int width, std::uint8_t* low, std::uint8_t* high) {
  HWY_DYNAMIC_DISPATCH(tile_extrema)(rows, width, low, high);
}

void threshold_tiles(const PixelRows& rows, int width, const TileRow& above, const TileRow& here,
                     const TileRow& below, ContrastRule rule, const BitRows& black,
                     const BitRows& white) {
  // The vector path writes bits as bytes.
  if constexpr (std::endian::native == std::endian::little) {
    HWY_DYNAMIC_DISPATCH(threshold_tiles)
    (rows, width, above, here, below, rule, black, white);
  } else {
    scalar::threshold_tiles(rows, width, above, here, below, rule, black, white);
  }
}

}  // namespace tagmint::detect
#endif
