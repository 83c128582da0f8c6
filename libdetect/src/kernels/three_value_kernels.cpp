#include "kernels/three_value_kernels.h"

#include <algorithm>

// Highway compiles this file once for each set of instructions.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/three_value_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Vectors reach no farther beyond a pixel than the padding of a row of extrema.
using Bytes = hn::CappedTag<std::uint8_t, 64>;
using ByteVector = hn::Vec<Bytes>;

struct Least {
  HWY_ATTR ByteVector operator()(ByteVector a, ByteVector b) const { return hn::Min(a, b); }
};
struct Most {
  HWY_ATTR ByteVector operator()(ByteVector a, ByteVector b) const { return hn::Max(a, b); }
};

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

HWY_ATTR void three_values_at(const PixelRows& rows, int x, const TileRow& above,
                              const TileRow& here, const TileRow& below, std::uint8_t floor,
                              const ByteRows& out) {
  const Bytes d;
  const ByteVector low = neighbourhood(above.low, here.low, below.low, x, Least());
  const ByteVector high = neighbourhood(above.high, here.high, below.high, x, Most());
  // The mean rounded down is the complement of the complements' mean rounded up.
  const ByteVector level = hn::Not(hn::AverageRound(hn::Not(low), hn::Not(high)));
  const ByteVector contrast = hn::Sub(high, low);
  // Unsigned a >= b is max(a, b) == a.
  const auto known = hn::Eq(hn::Max(contrast, hn::Set(d, floor)), contrast);
  const ByteVector zero = hn::Zero(d), white = hn::Set(d, 255), unknown = hn::Set(d, 127);
  for (int i = 0; i < kTile; ++i) {
    std::uint8_t* const to = out[static_cast<std::size_t>(i)];
    if (to == nullptr) continue;
    const ByteVector pixels = hn::LoadU(d, rows[static_cast<std::size_t>(i)] + x);
    // A pixel at or below the level is black.
    const auto black = hn::Eq(hn::Min(pixels, level), pixels);
    const ByteVector value = hn::IfThenElse(black, zero, white);
    hn::StoreU(hn::IfThenElse(known, value, unknown), d, to + x);
  }
}

HWY_ATTR void three_values(const PixelRows& rows, int width, const TileRow& above,
                           const TileRow& here, const TileRow& below, std::uint8_t floor,
                           const ByteRows& out) {
  const int lanes = static_cast<int>(hn::Lanes(Bytes()));
  int x = 0;
  for (; x + lanes <= width; x += lanes) three_values_at(rows, x, above, here, below, floor, out);
  scalar::three_values(rows, x, width, above, here, below, floor, out);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {

void scalar::three_values(const PixelRows& rows, int begin, int width, const TileRow& above,
                          const TileRow& here, const TileRow& below, std::uint8_t floor,
                          const ByteRows& out) {
  for (int x = begin; x < width; ++x) {
    int low = 255, high = 0;
    for (const TileRow* row : {&above, &here, &below}) {
      for (const int at : {x - kTile, x, x + kTile}) {
        low = std::min<int>(low, row->low[at]);
        high = std::max<int>(high, row->high[at]);
      }
    }
    for (std::size_t i = 0; i < kTile; ++i) {
      if (out[i] == nullptr) continue;
      out[i][x] = high - low < floor ? 127 : rows[i][x] > (low + high) / 2 ? 255 : 0;
    }
  }
}

HWY_EXPORT(three_values);

void three_values(const PixelRows& rows, int width, const TileRow& above, const TileRow& here,
                  const TileRow& below, std::uint8_t floor, const ByteRows& out) {
  HWY_DYNAMIC_DISPATCH(three_values)(rows, width, above, here, below, floor, out);
}

}  // namespace tagmint::detect
#endif
