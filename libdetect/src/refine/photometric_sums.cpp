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

#ifndef TAGMINT_REFINE_PHOTOMETRIC_SUMS_ONCE
#define TAGMINT_REFINE_PHOTOMETRIC_SUMS_ONCE
namespace tagmint::detect {

/// One number for all pixels of a block, ready to be loaded.
struct alignas(64) Same {
  float value[kPixelBlock];
  void operator=(double number) { std::fill_n(value, kPixelBlock, static_cast<float>(number)); }
};

/// The parameters as the kernels load them, and what follows from them.
struct KernelConstants {
  Same to_cells[8];
  Same black, contrast, light_x, light_y, tone, one, half;
  Same per_px;       ///< 1 / spread
  Same per_outlier;  ///< 1 / outlier scale
  Same share[5];     ///< terms of the edge profile, of its slope and of its derivative by tails
  Same density[5];
  Same by_tails[5];
};

inline void set_constants(const PhotometricParameters& p, double outlier_scale,
                          KernelConstants& c) {
  for (int i = 0; i < 8; ++i) c.to_cells[i] = p.to_cells[i];
  c.black = p.black;
  c.contrast = p.contrast;
  c.light_x = p.light_x;
  c.light_y = p.light_y;
  c.tone = p.tone;
  c.one = 1;
  c.half = 0.5;
  c.per_px = std::exp(-p.log_spread);
  c.per_outlier = 1 / outlier_scale;
  for (int k = 0; k < 5; ++k) {
    const double term = kEdgeTerms[k] + p.tails * kTailTerms[k];
    c.share[k] = term;
    c.density[k] = (2 * k + 1) * term;
    c.by_tails[k] = kTailTerms[k];
  }
}

}  // namespace tagmint::detect
#endif

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
constexpr std::size_t kBatch = 8;

/// Columns of one block of pixels.
struct Columns {
  alignas(64) float value[kColumns][kPixelBlock];
  alignas(64) float weight[kPixelBlock];
};

/// Sums by lane: product of columns a <= b at [a][b].
struct LaneSums {
  alignas(64) float product[kColumns][kColumns][kPixelBlock];
};

HWY_ATTR HWY_INLINE V mul_add(V a, V b, V c) { return hn::Add(hn::Mul(a, b), c); }

/// One edge of the surroundings as pixels see it.
struct Edge {
  V share;      // of white, across this edge alone
  V density;    // its derivative by the place, per standard deviation
  V by_spread;  // by the logarithm of the spread
  V by_tails;
};

/// edge_profile() at several places.
HWY_ATTR HWY_INLINE Edge edge_at(V t, const KernelConstants& c) {
  const Floats d;
  const auto term = [&](const Same& same) HWY_ATTR { return hn::Load(d, same.value); };
  const V reach = hn::Set(d, static_cast<float>(kEdgeReach));
  t = hn::Max(hn::Min(t, reach), hn::Neg(reach));
  const V s = hn::Mul(t, t);
  V share = term(c.share[4]);
  V density = term(c.density[4]);
  V by_tails = term(c.by_tails[4]);
  for (int k = 3; k >= 0; --k) {
    share = mul_add(share, s, term(c.share[k]));
    density = mul_add(density, s, term(c.density[k]));
    by_tails = mul_add(by_tails, s, term(c.by_tails[k]));
  }
  return {mul_add(t, share, term(c.half)), density, hn::Neg(hn::Mul(t, density)),
          hn::Mul(t, by_tails)};
}

/// The edges that count along one axis, from the first on.
struct Edges {
  Edge first, second, third, fourth;
};

template <int kWhich>
HWY_ATTR HWY_INLINE const Edge& edge_of(const Edges& edges) {
  if constexpr (kWhich == 1) return edges.first;
  if constexpr (kWhich == 2) return edges.second;
  if constexpr (kWhich == 3) return edges.third;
  if constexpr (kWhich == 4) return edges.fourth;
}

template <int kEdges>
HWY_ATTR HWY_INLINE Edges edges_around(V beyond, V per_spread, const KernelConstants& c) {
  const Floats d;
  const auto at = [&](float line) HWY_ATTR {
    return edge_at(hn::Mul(hn::Sub(beyond, hn::Set(d, line)), per_spread), c);
  };
  Edges edges;
  edges.first = at(0);
  if constexpr (kEdges > 1) edges.second = at(1);
  if constexpr (kEdges > 2) edges.third = at(2);
  if constexpr (kEdges > 3) edges.fourth = at(3);
  return edges;
}

/// The packed words of pixels; as many as the edges need.
struct Words {
  hn::Vec<Ints> first, second, third, fourth;
};

/// M(a, b) from the packed words: the four bits go to the top and come back with their sign.
template <int kCode>
HWY_ATTR HWY_INLINE V mixed_difference(const Words& words) {
  const Floats d;
  constexpr int kWord = kCode / kCodesPerWord;
  constexpr int kUp = 28 - 4 * (kCode % kCodesPerWord);
  const auto signed_bits = [](hn::Vec<Ints> word)
                               HWY_ATTR { return hn::ShiftRight<28>(hn::ShiftLeft<kUp>(word)); };
  if constexpr (kWord == 0) return hn::ConvertTo(d, signed_bits(words.first));
  if constexpr (kWord == 1) return hn::ConvertTo(d, signed_bits(words.second));
  if constexpr (kWord == 2) return hn::ConvertTo(d, signed_bits(words.third));
  if constexpr (kWord == 3) return hn::ConvertTo(d, signed_bits(words.fourth));
}

/// Adds the columns of row `kRow` of the surroundings from `kColumn` on.
template <int kEdges, int kRow, int kColumn = 1>
HWY_ATTR HWY_INLINE void add_columns(const Words& words, const Edges& x, Edge& row) {
  constexpr int kSide = kEdges + 1;
  if constexpr (kColumn < kSide) {
    const V m = mixed_difference<kColumn + kRow * kSide>(words);
    const Edge& edge = edge_of<kColumn>(x);
    row.share = mul_add(m, edge.share, row.share);
    row.density = mul_add(m, edge.density, row.density);
    row.by_spread = mul_add(m, edge.by_spread, row.by_spread);
    row.by_tails = mul_add(m, edge.by_tails, row.by_tails);
    add_columns<kEdges, kRow, kColumn + 1>(words, x, row);
  }
}

/// Sums over the surroundings of products of what stands across x and across y.
struct Mixture {
  V share_share, density_share, share_density, by_spread, by_tails;
  V density_density, spread_spread, spread_density, density_spread;
};

/// Adds row `kRow` of the surroundings, then those below it.
template <int kEdges, int kRow = 0>
HWY_ATTR HWY_INLINE void add_rows(const Words& words, const Edges& x, const Edges& y,
                                  Mixture& sum) {
  constexpr int kSide = kEdges + 1;
  if constexpr (kRow < kSide) {
    const V zero = hn::Zero(Floats());
    Edge row = {mixed_difference<kRow * kSide>(words), zero, zero, zero};
    add_columns<kEdges, kRow>(words, x, row);
    if constexpr (kRow == 0) {
      sum = {row.share, row.density, zero, row.by_spread, row.by_tails, zero, zero, zero, zero};
    } else {
      const Edge& edge = edge_of<kRow>(y);
      sum.share_share = mul_add(row.share, edge.share, sum.share_share);
      sum.density_share = mul_add(row.density, edge.share, sum.density_share);
      sum.share_density = mul_add(row.share, edge.density, sum.share_density);
      sum.by_spread = mul_add(row.by_spread, edge.share, sum.by_spread);
      sum.by_spread = mul_add(row.share, edge.by_spread, sum.by_spread);
      sum.by_tails = mul_add(row.by_tails, edge.share, sum.by_tails);
      sum.by_tails = mul_add(row.share, edge.by_tails, sum.by_tails);
      sum.density_density = mul_add(row.density, edge.density, sum.density_density);
      sum.spread_spread = mul_add(row.by_spread, edge.by_spread, sum.spread_spread);
      sum.spread_density = mul_add(row.by_spread, edge.density, sum.spread_density);
      sum.density_spread = mul_add(row.density, edge.by_spread, sum.density_spread);
    }
    add_rows<kEdges, kRow + 1>(words, x, y, sum);
  }
}

/// Twice the share of white at pixels, and its derivatives by the place in cells.
struct Whiteness {
  V share, by_x, by_y;
};

HWY_ATTR HWY_INLINE Whiteness whiteness(const Mixture& m, V per_x, V per_y, V cosine) {
  const V half_cosine = hn::Mul(cosine, hn::Set(Floats(), 0.5F));
  return {mul_add(cosine, mul_add(half_cosine, m.spread_spread, m.density_density), m.share_share),
          hn::Mul(per_x, mul_add(cosine, m.spread_density, m.density_share)),
          hn::Mul(per_y, mul_add(cosine, m.density_spread, m.share_density))};
}

template <int kEdges>
HWY_ATTR HWY_INLINE Words load_words(const PhotometricPixels& pixels, std::size_t i) {
  const Ints di;
  const auto load = [&](int k) HWY_ATTR {
    return hn::LoadU(di, reinterpret_cast<const std::int32_t*>(pixels.pattern[k].data() + i));
  };
  Words words;
  words.first = load(0);
  if constexpr (words_for_edges(kEdges) > 1) words.second = load(1);
  if constexpr (words_for_edges(kEdges) > 2) {
    words.third = load(2);
    words.fourth = load(3);
  }
  return words;
}

/// The columns of the pixels from i on, as predict() has them, and their weights.
template <int kEdges>
HWY_ATTR HWY_INLINE void fill_columns(const PhotometricPixels& pixels, std::size_t i,
                                      const KernelConstants& c, std::size_t lane, Columns& out) {
  const Floats d;
  const auto set = [&](const Same& same) HWY_ATTR { return hn::Load(d, same.value); };
  const auto load = [&](const std::vector<float>& from)
                        HWY_ATTR { return hn::LoadU(d, from.data() + i); };
  const auto store = [&](int column, V value)
                         HWY_ATTR { hn::Store(value, d, out.value[column] + lane); };
  const V x = load(pixels.x);
  const V y = load(pixels.y);
  const V one = set(c.one);
  const Same* g = c.to_cells;
  const V w = hn::Div(one, mul_add(x, set(g[6]), mul_add(y, set(g[7]), one)));
  const V u = hn::Mul(mul_add(x, set(g[0]), mul_add(y, set(g[1]), set(g[2]))), w);
  const V v = hn::Mul(mul_add(x, set(g[3]), mul_add(y, set(g[4]), set(g[5]))), w);
  const V per_x = hn::Mul(load(pixels.across_x), set(c.per_px));
  const V per_y = hn::Mul(load(pixels.across_y), set(c.per_px));
  const Edges edges_x = edges_around<kEdges>(hn::Sub(u, load(pixels.line_x)), per_x, c);
  const Edges edges_y = edges_around<kEdges>(hn::Sub(v, load(pixels.line_y)), per_y, c);
  Mixture mixture;
  add_rows<kEdges>(load_words<kEdges>(pixels, i), edges_x, edges_y, mixture);
  const Whiteness white = whiteness(mixture, per_x, per_y, load(pixels.cosine));

  const V half = set(c.half);  // brightness counts twice
  const V t = hn::Mul(white.share, half);
  const V mixed = hn::Mul(t, hn::Sub(one, t));
  const V tone = set(c.tone);
  const V toned = mul_add(tone, mixed, t);
  const V light = mul_add(x, set(c.light_x), mul_add(y, set(c.light_y), one));
  const V in_full_light = mul_add(toned, set(c.contrast), set(c.black));
  const V light_contrast = hn::Mul(light, set(c.contrast));
  const V tone_slope = mul_add(tone, hn::Sub(one, white.share), one);
  const V by_share = hn::Mul(hn::Mul(light_contrast, tone_slope), half);
  store(kBlackLevel, light);
  store(kContrast, hn::Mul(light, toned));
  store(kLightX, hn::Mul(x, in_full_light));
  store(kLightY, hn::Mul(y, in_full_light));
  store(kLogSpread, hn::Mul(by_share, mixture.by_spread));
  store(kTails, hn::Mul(by_share, mixture.by_tails));
  store(kTone, hn::Mul(light_contrast, mixed));

  const V by_share_w = hn::Mul(by_share, w);
  const V by_u = hn::Mul(by_share_w, white.by_x);
  const V by_v = hn::Mul(by_share_w, white.by_y);
  const V by_w = hn::Neg(mul_add(by_u, u, hn::Mul(by_v, v)));
  store(0, hn::Mul(by_u, x));
  store(1, hn::Mul(by_u, y));
  store(2, by_u);
  store(3, hn::Mul(by_v, x));
  store(4, hn::Mul(by_v, y));
  store(5, by_v);
  store(6, hn::Mul(by_w, x));
  store(7, hn::Mul(by_w, y));

  const V residual = hn::Sub(load(pixels.gray), hn::Mul(light, in_full_light));
  const V far = hn::Mul(residual, set(c.per_outlier));
  store(kPhotometricParameters, residual);
  hn::Store(hn::Div(load(pixels.weight), mul_add(far, far, one)), d, out.weight + lane);
}

/// Adds products of rows a, a + 1 with the kWide (3 to 5) columns from b on: a tile that fits the
/// registers. Sums have names of their own, because arrays of vectors would live in memory.
template <int kWide>
HWY_ATTR HWY_INLINE void add_tile(const Columns* blocks, std::size_t count, int a, int b,
                                  std::size_t lane, LaneSums& sums) {
  const Floats d;
  const auto at = [&](int row, int k) HWY_ATTR { return sums.product[a + row][b + k] + lane; };
  V a0 = hn::Load(d, at(0, 0)), b0 = hn::Load(d, at(1, 0));
  V a1 = hn::Load(d, at(0, 1)), b1 = hn::Load(d, at(1, 1));
  V a2 = a0, a3 = a0, a4 = a0, b2 = a0, b3 = a0, b4 = a0;
  if constexpr (kWide > 2) a2 = hn::Load(d, at(0, 2)), b2 = hn::Load(d, at(1, 2));
  if constexpr (kWide > 3) a3 = hn::Load(d, at(0, 3)), b3 = hn::Load(d, at(1, 3));
  if constexpr (kWide > 4) a4 = hn::Load(d, at(0, 4)), b4 = hn::Load(d, at(1, 4));
  for (std::size_t i = 0; i < count; ++i) {
    const Columns& block = blocks[i];
    const V weight = hn::Load(d, block.weight + lane);
    const V row = hn::Mul(weight, hn::Load(d, block.value[a] + lane));
    const V next = hn::Mul(weight, hn::Load(d, block.value[a + 1] + lane));
    const auto column = [&](int k) HWY_ATTR { return hn::Load(d, block.value[b + k] + lane); };
    a0 = mul_add(row, column(0), a0), b0 = mul_add(next, column(0), b0);
    a1 = mul_add(row, column(1), a1), b1 = mul_add(next, column(1), b1);
    if constexpr (kWide > 2) a2 = mul_add(row, column(2), a2), b2 = mul_add(next, column(2), b2);
    if constexpr (kWide > 3) a3 = mul_add(row, column(3), a3), b3 = mul_add(next, column(3), b3);
    if constexpr (kWide > 4) a4 = mul_add(row, column(4), a4), b4 = mul_add(next, column(4), b4);
  }
  hn::Store(a0, d, at(0, 0)), hn::Store(b0, d, at(1, 0));
  hn::Store(a1, d, at(0, 1)), hn::Store(b1, d, at(1, 1));
  if constexpr (kWide > 2) hn::Store(a2, d, at(0, 2)), hn::Store(b2, d, at(1, 2));
  if constexpr (kWide > 3) hn::Store(a3, d, at(0, 3)), hn::Store(b3, d, at(1, 3));
  if constexpr (kWide > 4) hn::Store(a4, d, at(0, 4)), hn::Store(b4, d, at(1, 4));
}

/// Adds all products of columns a <= b but for the last column's square.
HWY_ATTR void add_products(const Columns* blocks, std::size_t count, std::size_t lane,
                           LaneSums& sums) {
  const auto five = [&](int a, int b) HWY_ATTR { add_tile<5>(blocks, count, a, b, lane, sums); };
  const auto four = [&](int a, int b) HWY_ATTR { add_tile<4>(blocks, count, a, b, lane, sums); };
  const auto three = [&](int a, int b) HWY_ATTR { add_tile<3>(blocks, count, a, b, lane, sums); };
  const auto two = [&](int a, int b) HWY_ATTR { add_tile<2>(blocks, count, a, b, lane, sums); };
  for (int b = 0; b < kColumns; b += 4) four(0, b);
  five(2, 2), five(2, 7), four(2, 12);
  for (int b = 4; b < kColumns; b += 4) four(4, b);
  five(6, 6), five(6, 11);
  for (int b = 8; b < kColumns; b += 4) four(8, b);
  three(10, 10), three(10, 13);
  four(12, 12);
  two(14, 14);
}

/// Adds the products of five columns from `a` on with the last one, the residual.
HWY_ATTR HWY_INLINE void add_last_of_five(const Columns* blocks, std::size_t count, int a,
                                          std::size_t lane, LaneSums& sums) {
  const Floats d;
  const auto at = [&](int k) HWY_ATTR { return sums.product[a + k][kColumns - 1] + lane; };
  V s0 = hn::Load(d, at(0)), s1 = hn::Load(d, at(1)), s2 = hn::Load(d, at(2));
  V s3 = hn::Load(d, at(3)), s4 = hn::Load(d, at(4));
  for (std::size_t i = 0; i < count; ++i) {
    const Columns& block = blocks[i];
    const V last =
        hn::Mul(hn::Load(d, block.weight + lane), hn::Load(d, block.value[kColumns - 1] + lane));
    const auto column = [&](int k) HWY_ATTR { return hn::Load(d, block.value[a + k] + lane); };
    s0 = mul_add(last, column(0), s0);
    s1 = mul_add(last, column(1), s1);
    s2 = mul_add(last, column(2), s2);
    s3 = mul_add(last, column(3), s3);
    s4 = mul_add(last, column(4), s4);
  }
  hn::Store(s0, d, at(0)), hn::Store(s1, d, at(1)), hn::Store(s2, d, at(2));
  hn::Store(s3, d, at(3)), hn::Store(s4, d, at(4));
}

/// Adds the products of all columns with the last one alone.
HWY_ATTR void add_last_column(const Columns* blocks, std::size_t count, std::size_t lane,
                              LaneSums& sums) {
  for (int a = 0; a < kPhotometricParameters; a += 5) {
    add_last_of_five(blocks, count, a, lane, sums);
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

/// In one order with all sets of instructions.
double sum_of_lanes(const float* lanes) {
  float eight[8];
  float four[4];
  for (int i = 0; i < 8; ++i) eight[i] = lanes[i] + lanes[i + 8];
  for (int i = 0; i < 4; ++i) four[i] = eight[i] + eight[i + 4];
  return static_cast<double>((four[0] + four[2]) + (four[1] + four[3]));
}

template <int kEdges>
HWY_ATTR PhotometricSums sums_within(const PhotometricPixels& pixels,
                                     const PhotometricParameters& p, const PhotometricPass& pass) {
  const std::size_t lanes = hn::Lanes(Floats());
  KernelConstants constants;
  set_constants(p, pass.outlier_scale, constants);
  Columns batch[kBatch];
  LaneSums sums;
  for (int a = 0; a < kColumns; ++a) {
    const int first = pass.normal ? a : kColumns - 1;
    std::fill_n(&sums.product[a][first][0], (kColumns - first) * kPixelBlock, 0.0F);
  }
  alignas(64) float squared[kPixelBlock] = {};
  alignas(64) float weights[kPixelBlock] = {};
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
      fill_columns<kEdges>(pixels, block * kPixelBlock + lane, constants, lane, batch[filled]);
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

PhotometricSums sums_of_wide_cells(const PhotometricPixels& pixels, const PhotometricParameters& p,
                                   const PhotometricPass& pass) {
  return sums_within<kWideCells>(pixels, p, pass);
}

PhotometricSums sums_of_middling_cells(const PhotometricPixels& pixels,
                                       const PhotometricParameters& p,
                                       const PhotometricPass& pass) {
  return sums_within<kMiddlingCells>(pixels, p, pass);
}

PhotometricSums sums_of_small_cells(const PhotometricPixels& pixels, const PhotometricParameters& p,
                                    const PhotometricPass& pass) {
  return sums_within<kSmallCells>(pixels, p, pass);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {
namespace {

HWY_EXPORT(sums_of_wide_cells);
HWY_EXPORT(sums_of_middling_cells);
HWY_EXPORT(sums_of_small_cells);

}  // namespace

PhotometricSums photometric_sums(const PhotometricPixels& pixels,
                                 const PhotometricParameters& parameters, int edges,
                                 const PhotometricPass& pass) {
  switch (edges) {
    case kWideCells:
      return HWY_DYNAMIC_DISPATCH(sums_of_wide_cells)(pixels, parameters, pass);
    case kMiddlingCells:
      return HWY_DYNAMIC_DISPATCH(sums_of_middling_cells)(pixels, parameters, pass);
    default:
      return HWY_DYNAMIC_DISPATCH(sums_of_small_cells)(pixels, parameters, pass);
  }
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
