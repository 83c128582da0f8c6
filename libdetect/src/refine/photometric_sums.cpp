#include "refine/photometric_sums.h"

#include <algorithm>
#include <cmath>

#include "refine/edge_profile.h"

// Highway compiles this file once for each set of instructions. Products and sums stay apart (the
// build asks for no contraction either), so that all of them round alike.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refine/photometric_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kPixelBlock>;
using Ints = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;

/// The derivatives and, as the last column, the residual.
constexpr int kColumns = kPhotometricParameters + 1;
/// Blocks whose columns are kept before they are multiplied: small enough for the first cache.
constexpr std::size_t kBatch = 16;

/// Columns of one block of pixels.
struct Columns {
  alignas(32) float value[kColumns][kPixelBlock];
  alignas(32) float weight[kPixelBlock];
};

/// Sums by lane: product of columns a <= b at [a][b].
struct LaneSums {
  alignas(32) float product[kColumns][kColumns][kPixelBlock];
};

HWY_ATTR HWY_INLINE V mul_add(V a, V b, V c) { return hn::Add(hn::Mul(a, b), c); }

/// 1/2 + t value, and the slope; edge_profile() for several places.
HWY_ATTR HWY_INLINE void edge_of(V t, V& share, V& slope) {
  const Floats d;
  const auto reach = hn::Set(d, static_cast<float>(kEdgeReach));
  t = hn::Max(hn::Min(t, reach), hn::Neg(reach));
  const V s = hn::Mul(t, t);
  V value = hn::Set(d, static_cast<float>(kEdgeTerms[4]));
  slope = hn::Set(d, static_cast<float>(9 * kEdgeTerms[4]));
  for (int k = 3; k >= 0; --k) {
    value = mul_add(value, s, hn::Set(d, static_cast<float>(kEdgeTerms[k])));
    slope = mul_add(slope, s, hn::Set(d, static_cast<float>((2 * k + 1) * kEdgeTerms[k])));
  }
  share = mul_add(t, value, hn::Set(d, 0.5F));
}

/// The edges around a cell along one axis; entry 0 stands for edge 1.
template <int kReach>
struct Edges {
  V share[2 * kReach];
  V by_place[2 * kReach];
  V by_spread[2 * kReach];
};

template <int kReach>
HWY_ATTR HWY_INLINE Edges<kReach> edges_around(V inside, V per_spread) {
  const Floats d;
  Edges<kReach> edges;
  for (int a = 1; a <= 2 * kReach; ++a) {
    const V t = hn::Mul(hn::Add(inside, hn::Set(d, static_cast<float>(kReach - a))), per_spread);
    V slope;
    edge_of(t, edges.share[a - 1], slope);
    edges.by_place[a - 1] = hn::Mul(slope, per_spread);
    edges.by_spread[a - 1] = hn::Neg(hn::Mul(t, slope));
  }
  return edges;
}

/// M(a, b) from the packed words: the four bits go to the top and come back with their sign.
template <int kCode>
HWY_ATTR HWY_INLINE V mixed_difference(const hn::Vec<Ints> (&words)[kMaxPatternWords]) {
  const Floats d;
  constexpr int kFirst = 4 * (kCode % kCodesPerWord);
  return hn::ConvertTo(
      d, hn::ShiftRight<28>(hn::ShiftLeft<28 - kFirst>(words[kCode / kCodesPerWord])));
}

struct Whiteness {
  V share, by_x, by_y, by_spread;
};

/// Adds row `kRow` of the surroundings, then those below it.
template <int kReach, int kRow, int kColumn = 1>
HWY_ATTR HWY_INLINE void add_columns(const hn::Vec<Ints> (&words)[kMaxPatternWords],
                                     const Edges<kReach>& x, V& share, V& by_x, V& by_spread) {
  constexpr int kSide = 2 * kReach + 1;
  if constexpr (kColumn < kSide) {
    const V m = mixed_difference<kColumn + kRow * kSide>(words);
    share = mul_add(m, x.share[kColumn - 1], share);
    by_x = mul_add(m, x.by_place[kColumn - 1], by_x);
    by_spread = mul_add(m, x.by_spread[kColumn - 1], by_spread);
    add_columns<kReach, kRow, kColumn + 1>(words, x, share, by_x, by_spread);
  }
}

template <int kReach, int kRow = 0>
HWY_ATTR HWY_INLINE void add_rows(const hn::Vec<Ints> (&words)[kMaxPatternWords],
                                  const Edges<kReach>& x, const Edges<kReach>& y,
                                  Whiteness& white) {
  constexpr int kSide = 2 * kReach + 1;
  const Floats d;
  if constexpr (kRow < kSide) {
    V share = mixed_difference<kRow * kSide>(words);
    V by_x = hn::Zero(d);
    V by_spread = hn::Zero(d);
    add_columns<kReach, kRow>(words, x, share, by_x, by_spread);
    if constexpr (kRow == 0) {
      white = {share, by_x, hn::Zero(d), by_spread};
    } else {
      white.share = mul_add(share, y.share[kRow - 1], white.share);
      white.by_x = mul_add(by_x, y.share[kRow - 1], white.by_x);
      white.by_y = mul_add(share, y.by_place[kRow - 1], white.by_y);
      white.by_spread = mul_add(by_spread, y.share[kRow - 1], white.by_spread);
      white.by_spread = mul_add(share, y.by_spread[kRow - 1], white.by_spread);
    }
    add_rows<kReach, kRow + 1>(words, x, y, white);
  }
}

/// The columns of the pixels from i on, as predict() has them, and their weights.
template <int kReach>
HWY_ATTR HWY_INLINE void fill_columns(const PhotometricPixels& pixels, std::size_t i,
                                      const PhotometricParameters& p, float per_px,
                                      float per_outlier, std::size_t lane, Columns& out) {
  const Floats d;
  const Ints di;
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<float>(value)); };
  const auto load = [&](const std::vector<float>& from)
                        HWY_ATTR { return hn::LoadU(d, from.data() + i); };
  const V x = load(pixels.x);
  const V y = load(pixels.y);
  const V one = set(1);
  const auto& g = p.to_cells;
  const V w = hn::Div(one, mul_add(x, set(g[6]), mul_add(y, set(g[7]), one)));
  const V u = hn::Mul(mul_add(x, set(g[0]), mul_add(y, set(g[1]), set(g[2]))), w);
  const V v = hn::Mul(mul_add(x, set(g[3]), mul_add(y, set(g[4]), set(g[5]))), w);
  const V scale = hn::Set(d, per_px);
  const auto across_x = edges_around<kReach>(hn::Sub(u, load(pixels.cell_x)),
                                             hn::Mul(load(pixels.across_x), scale));
  const auto across_y = edges_around<kReach>(hn::Sub(v, load(pixels.cell_y)),
                                             hn::Mul(load(pixels.across_y), scale));
  hn::Vec<Ints> words[kMaxPatternWords];
  for (int k = 0; k < words_for_reach(kReach); ++k) {
    words[k] = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(pixels.pattern[k].data() + i));
  }
  Whiteness white;
  add_rows<kReach>(words, across_x, across_y, white);

  const V half = set(0.5);  // brightness counts twice
  const V t = hn::Mul(white.share, half);
  const V mixed = hn::Mul(t, hn::Sub(one, t));
  const V tone = set(p.tone);
  const V toned = mul_add(tone, mixed, t);
  const V light = mul_add(x, set(p.light_x), mul_add(y, set(p.light_y), one));
  const V in_full_light = mul_add(toned, set(p.contrast), set(p.black));
  const V light_contrast = hn::Mul(light, set(p.contrast));
  const V tone_slope = mul_add(tone, hn::Sub(one, white.share), one);
  const V by_share = hn::Mul(hn::Mul(light_contrast, tone_slope), half);
  const V by_share_w = hn::Mul(by_share, w);
  const V by_u = hn::Mul(by_share_w, white.by_x);
  const V by_v = hn::Mul(by_share_w, white.by_y);
  const V by_w = hn::Neg(mul_add(by_u, u, hn::Mul(by_v, v)));
  const V residual = hn::Sub(load(pixels.gray), hn::Mul(light, in_full_light));
  const V far = hn::Mul(residual, hn::Set(d, per_outlier));
  const V weight = hn::Div(load(pixels.weight), mul_add(far, far, one));

  const auto store = [&](int column, V value)
                         HWY_ATTR { hn::Store(value, d, out.value[column] + lane); };
  store(0, hn::Mul(by_u, x));
  store(1, hn::Mul(by_u, y));
  store(2, by_u);
  store(3, hn::Mul(by_v, x));
  store(4, hn::Mul(by_v, y));
  store(5, by_v);
  store(6, hn::Mul(by_w, x));
  store(7, hn::Mul(by_w, y));
  store(kBlackLevel, light);
  store(kContrast, hn::Mul(light, toned));
  store(kLightX, hn::Mul(x, in_full_light));
  store(kLightY, hn::Mul(y, in_full_light));
  store(kLogSpread, hn::Mul(by_share, white.by_spread));
  store(kTone, hn::Mul(light_contrast, mixed));
  store(kPhotometricParameters, residual);
  hn::Store(weight, d, out.weight + lane);
}

/// Adds products of rows a, a + 1 with kWide columns from b on: a tile that fits the registers.
template <int kWide>
HWY_ATTR HWY_INLINE void add_tile(const Columns* blocks, std::size_t count, int a, int b,
                                  std::size_t lane, LaneSums& sums) {
  const Floats d;
  V first[kWide];
  V second[kWide];
  for (int k = 0; k < kWide; ++k) {
    first[k] = hn::Load(d, sums.product[a][b + k] + lane);
    second[k] = hn::Load(d, sums.product[a + 1][b + k] + lane);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Columns& block = blocks[i];
    const V weight = hn::Load(d, block.weight + lane);
    const V row = hn::Mul(weight, hn::Load(d, block.value[a] + lane));
    const V next = hn::Mul(weight, hn::Load(d, block.value[a + 1] + lane));
    for (int k = 0; k < kWide; ++k) {
      const V column = hn::Load(d, block.value[b + k] + lane);
      first[k] = mul_add(row, column, first[k]);
      second[k] = mul_add(next, column, second[k]);
    }
  }
  for (int k = 0; k < kWide; ++k) {
    hn::Store(first[k], d, sums.product[a][b + k] + lane);
    hn::Store(second[k], d, sums.product[a + 1][b + k] + lane);
  }
}

/// Adds all products of columns.
HWY_ATTR void add_products(const Columns* blocks, std::size_t count, std::size_t lane,
                           LaneSums& sums) {
  const auto five = [&](int a, int b) HWY_ATTR { add_tile<5>(blocks, count, a, b, lane, sums); };
  const auto four = [&](int a, int b) HWY_ATTR { add_tile<4>(blocks, count, a, b, lane, sums); };
  const auto three = [&](int a, int b) HWY_ATTR { add_tile<3>(blocks, count, a, b, lane, sums); };
  five(0, 0), five(0, 5), five(0, 10);
  five(2, 2), four(2, 7), four(2, 11);
  four(4, 4), four(4, 8), three(4, 12);
  five(6, 6), four(6, 11);
  four(8, 8), three(8, 12);
  five(10, 10);
  three(12, 12);
}

/// Adds the products of all columns with the last one alone, the residual.
HWY_ATTR void add_last_column(const Columns* blocks, std::size_t count, std::size_t lane,
                              LaneSums& sums) {
  const Floats d;
  constexpr int kHalf = kColumns / 2;  // of the columns; the residual itself is done with the weight
  for (int half = 0; half < 2; ++half) {
    V sum[kHalf];
    for (int k = 0; k < kHalf; ++k) {
      sum[k] = hn::Load(d, sums.product[half * kHalf + k][kColumns - 1] + lane);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Columns& block = blocks[i];
      const V last = hn::Mul(hn::Load(d, block.weight + lane),
                             hn::Load(d, block.value[kColumns - 1] + lane));
      for (int k = 0; k < kHalf; ++k) {
        sum[k] = mul_add(last, hn::Load(d, block.value[half * kHalf + k] + lane), sum[k]);
      }
    }
    for (int k = 0; k < kHalf; ++k) {
      hn::Store(sum[k], d, sums.product[half * kHalf + k][kColumns - 1] + lane);
    }
  }
}

/// Adds the squared residuals and the weights.
HWY_ATTR void add_squares(const Columns* blocks, std::size_t count, std::size_t lane,
                          float* squared, float* weights) {
  const Floats d;
  V square_sum = hn::Load(d, squared + lane);
  V weight_sum = hn::Load(d, weights + lane);
  for (std::size_t i = 0; i < count; ++i) {
    const V weight = hn::Load(d, blocks[i].weight + lane);
    const V residual = hn::Load(d, blocks[i].value[kColumns - 1] + lane);
    square_sum = mul_add(hn::Mul(weight, residual), residual, square_sum);
    weight_sum = hn::Add(weight_sum, weight);
  }
  hn::Store(square_sum, d, squared + lane);
  hn::Store(weight_sum, d, weights + lane);
}

double sum_of_lanes(const float* lanes) {
  double sum = 0;
  for (int i = 0; i < kPixelBlock; ++i) sum += static_cast<double>(lanes[i]);
  return sum;
}

template <int kReach>
HWY_ATTR PhotometricSums sums_within(const PhotometricPixels& pixels,
                                     const PhotometricParameters& p, const PhotometricPass& pass) {
  const std::size_t lanes = hn::Lanes(Floats());
  const auto per_px = static_cast<float>(std::exp(-p.log_spread));
  const auto per_outlier = static_cast<float>(1 / pass.outlier_scale);
  Columns batch[kBatch];
  LaneSums sums;
  std::fill_n(&sums.product[0][0][0], kColumns * kColumns * kPixelBlock, 0.0F);
  alignas(32) float squared[kPixelBlock] = {};
  alignas(32) float weights[kPixelBlock] = {};
  std::size_t filled = 0;
  const auto empty_batch = [&]() HWY_ATTR {
    for (std::size_t lane = 0; lane < kPixelBlock; lane += lanes) {
      if (pass.normal) {
        add_products(batch, filled, lane, sums);
      } else {
        add_last_column(batch, filled, lane, sums);
      }
      add_squares(batch, filled, lane, squared, weights);
    }
    filled = 0;
  };
  for (std::size_t block = pass.first_block; block < pixels.blocks(); block += pass.block_step) {
    for (std::size_t lane = 0; lane < kPixelBlock; lane += lanes) {
      fill_columns<kReach>(pixels, block * kPixelBlock + lane, p, per_px, per_outlier, lane,
                           batch[filled]);
    }
    if (++filled == kBatch) empty_batch();
  }
  if (filled > 0) empty_batch();

  PhotometricSums total;
  for (int a = 0; a < kPhotometricParameters; ++a) {
    total.gradient[a] = sum_of_lanes(sums.product[a][kColumns - 1]);
    if (!pass.normal) continue;
    for (int b = a; b < kPhotometricParameters; ++b) {
      total.normal[a][b] = sum_of_lanes(sums.product[a][b]);
    }
  }
  total.squared = sum_of_lanes(squared);
  total.weight = sum_of_lanes(weights);
  return total;
}

PhotometricSums sums_of_near_cells(const PhotometricPixels& pixels, const PhotometricParameters& p,
                                   const PhotometricPass& pass) {
  return sums_within<1>(pixels, p, pass);
}

PhotometricSums sums_of_far_cells(const PhotometricPixels& pixels, const PhotometricParameters& p,
                                  const PhotometricPass& pass) {
  return sums_within<kMaxCellReach>(pixels, p, pass);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {
namespace {

HWY_EXPORT(sums_of_near_cells);
HWY_EXPORT(sums_of_far_cells);

}  // namespace

PhotometricSums photometric_sums(const PhotometricPixels& pixels,
                                 const PhotometricParameters& parameters, int pattern_reach,
                                 const PhotometricPass& pass) {
  if (pattern_reach == 1) {
    return HWY_DYNAMIC_DISPATCH(sums_of_near_cells)(pixels, parameters, pass);
  }
  return HWY_DYNAMIC_DISPATCH(sums_of_far_cells)(pixels, parameters, pass);
}

namespace scalar {

PhotometricSums photometric_sums(const PhotometricPixels& pixels, const TagPattern& pattern,
                                 const PhotometricParameters& parameters,
                                 const PhotometricPass& pass) {
  PhotometricSums sums;
  for (std::size_t block = pass.first_block; block < pixels.blocks(); block += pass.block_step) {
    const std::size_t end = std::min(pixels.size(), (block + 1) * kPixelBlock);
    for (std::size_t i = block * kPixelBlock; i < end; ++i) {
      const PhotometricPixel pixel = pixels.pixel(i);
      const PhotometricPrediction at = predict(pattern, pixel, parameters);
      const double residual = pixel.gray - at.gray;
      const double far = residual / pass.outlier_scale;
      const double weight = pixel.weight / (1 + far * far);
      for (int a = 0; a < kPhotometricParameters; ++a) {
        sums.gradient[a] += weight * at.slope[a] * residual;
        if (!pass.normal) continue;
        for (int b = a; b < kPhotometricParameters; ++b) {
          sums.normal[a][b] += weight * at.slope[a] * at.slope[b];
        }
      }
      sums.squared += weight * residual * residual;
      sums.weight += weight;
    }
  }
  return sums;
}

}  // namespace scalar
}  // namespace tagmint::detect
#endif  // HWY_ONCE
