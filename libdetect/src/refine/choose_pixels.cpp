#include "refine/choose_pixels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "refine/edge_profile.h"

// Highway compiles this file once for each set of instructions; as in photometric_sums.cpp, all of
// them round alike.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refine/choose_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef TAGMINT_REFINE_CHOOSE_PIXELS_ONCE
#define TAGMINT_REFINE_CHOOSE_PIXELS_ONCE
namespace tagmint::detect {

/// Where a pixel gets its full weight although cells of unknown colour reach into it: the share of
/// it that they take is this at half the weight.
inline constexpr float kUnknownShare = 0.04F;

/// Numbers that a row needs, as the kernels use them.
struct RowChoice {
  std::array<float, 8> to_cells;
  float origin_x, per_scale, scale;
  float y;  ///< of the row, frame
  float near_px, per_spread;
  float across_x, across_y;  ///< px from one grid line to the next in the middle of the tag
  float last_cell;           ///< width - 1
  int edges;
  const std::int32_t* flags;
  int width;
};

/// Pixels of one row: x0, x0 + step, ... `count` of them.
struct RowPixels {
  int x0 = 0;
  int step = 1;
  int count = 0;
};

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

HWY_ATTR HWY_INLINE V mul_add(V a, V b, V c) { return hn::Add(hn::Mul(a, b), c); }

/// Share of a pixel that lies t standard deviations and more beyond an edge: edge_profile(-t).
HWY_ATTR HWY_INLINE V share_beyond(V t) {
  const Floats d;
  const auto reach = hn::Set(d, static_cast<float>(kEdgeReach));
  t = hn::Min(t, reach);
  const V s = hn::Mul(t, t);
  V value = hn::Set(d, static_cast<float>(kEdgeTerms[4]));
  for (int k = 3; k >= 0; --k) {
    value = mul_add(value, s, hn::Set(d, static_cast<float>(kEdgeTerms[k])));
  }
  return hn::Sub(hn::Set(d, 0.5F), hn::Mul(t, value));
}

/// TagPattern::first_line() less the cell, from the place inside it.
HWY_ATTR HWY_INLINE V first_line(V inside, const RowChoice& c) {
  const Floats d;
  if (c.edges == kMiddlingCells) return hn::Zero(d);
  if (c.edges == kSmallCells) return hn::Set(d, -1.0F);
  return hn::IfThenElseZero(hn::Ge(inside, hn::Set(d, 0.5F)), hn::Set(d, 1.0F));
}

/// Writes the chosen pixels of a row behind those that are there, and where they are in the row;
/// returns how many.
HWY_ATTR std::size_t choose_in_row(const RowChoice& c, const RowPixels& row,
                                   PhotometricPixels& pixels, std::int32_t* columns) {
  const Floats d;
  const Ints di;
  const auto set = [&](float value) HWY_ATTR { return hn::Set(d, value); };
  const auto lanes = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d);
  const V one = set(1);
  const V none = set(1e9F);
  const auto& g = c.to_cells;
  const V w_row = set(g[7] * c.y + 1);
  const V u_row = set(g[1] * c.y + g[2]);
  const V v_row = set(g[4] * c.y + g[5]);
  std::size_t chosen = 0;
  for (int k = 0; k < row.count; k += lanes) {
    const auto column =
        hn::Add(hn::Mul(hn::Iota(di, k), hn::Set(di, row.step)), hn::Set(di, row.x0));
    const V x = hn::Mul(hn::Sub(hn::Add(hn::ConvertTo(d, column), set(0.5F)), set(c.origin_x)),
                        set(c.per_scale));
    const V w = hn::Div(one, mul_add(x, set(g[6]), w_row));
    const V u = hn::Mul(mul_add(x, set(g[0]), u_row), w);
    const V v = hn::Mul(mul_add(x, set(g[3]), v_row), w);
    const V cell_x = hn::Min(hn::Max(hn::Floor(u), zero), set(c.last_cell));
    const V cell_y = hn::Min(hn::Max(hn::Floor(v), zero), set(c.last_cell));
    const V in_x = hn::Sub(u, cell_x);
    const V in_y = hn::Sub(v, cell_y);
    auto wanted = hn::And(hn::And(hn::Ge(in_x, zero), hn::Le(in_x, one)),
                          hn::And(hn::Ge(in_y, zero), hn::Le(in_y, one)));
    wanted = hn::And(wanted,
                     hn::Lt(hn::ConvertTo(d, hn::Iota(di, k)), set(static_cast<float>(row.count))));
    if (hn::AllFalse(d, wanted)) continue;
    const auto index = hn::ConvertTo(di, mul_add(cell_y, set(static_cast<float>(c.width)), cell_x));
    const auto flags = hn::GatherIndex(di, c.flags, index);
    const auto has = [&](std::int32_t bits) HWY_ATTR {
      return hn::RebindMask(d, hn::Ne(hn::And(flags, hn::Set(di, bits)), hn::Zero(di)));
    };
    const V left = hn::Mul(in_x, set(c.across_x));
    const V right = hn::Sub(set(c.across_x), left);
    const V up = hn::Mul(in_y, set(c.across_y));
    const V down = hn::Sub(set(c.across_y), up);
    const auto nearest = [&](std::int32_t l, std::int32_t r, std::int32_t a,
                             std::int32_t b) HWY_ATTR {
      return hn::Min(
          hn::Min(hn::IfThenElse(has(l), left, none), hn::IfThenElse(has(r), right, none)),
          hn::Min(hn::IfThenElse(has(a), up, none), hn::IfThenElse(has(b), down, none)));
    };
    const V change = nearest(TagPattern::kChangeLeft, TagPattern::kChangeRight,
                             TagPattern::kChangeUp, TagPattern::kChangeDown);
    wanted = hn::And(wanted, hn::Le(change, set(c.near_px)));
    if (hn::AllFalse(d, wanted)) continue;
    const V unknown = nearest(TagPattern::kUnknownLeft, TagPattern::kUnknownRight,
                              TagPattern::kUnknownUp, TagPattern::kUnknownDown);
    const V share =
        hn::Mul(share_beyond(hn::Mul(unknown, set(c.per_spread))), set(1 / kUnknownShare));
    const V weight = hn::Div(one, mul_add(share, share, one));

    const V line_x = hn::Add(cell_x, first_line(in_x, c));
    const V line_y = hn::Add(cell_y, first_line(in_y, c));
    alignas(64) float values[4][kPixelBlock];
    hn::Store(x, d, values[0]);
    hn::Store(line_x, d, values[1]);
    hn::Store(line_y, d, values[2]);
    hn::Store(weight, d, values[3]);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, wanted, bits);
    for (unsigned rest = bits[0] | bits[1] << 8; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const std::size_t at = pixels.size() + chosen;
      pixels.x[at] = values[0][lane];
      pixels.line_x[at] = values[1][lane];
      pixels.line_y[at] = values[2][lane];
      pixels.weight[at] = values[3][lane];
      columns[chosen] = row.x0 + (k + lane) * row.step;
      ++chosen;
    }
  }
  return chosen;
}

/// Widths of cells and angles between grid lines at all chosen pixels.
HWY_ATTR void measure_grid(const RowChoice& c, PhotometricPixels& pixels) {
  const Floats d;
  const auto set = [&](float value) HWY_ATTR { return hn::Set(d, value); };
  const V one = set(1);
  const auto& g = c.to_cells;
  for (std::size_t i = 0; i < pixels.blocks() * kPixelBlock; i += hn::Lanes(d)) {
    const V x = hn::LoadU(d, pixels.x.data() + i);
    const V y = hn::LoadU(d, pixels.y.data() + i);
    const V w = hn::Div(one, mul_add(x, set(g[6]), mul_add(y, set(g[7]), one)));
    const V u = hn::Mul(mul_add(x, set(g[0]), mul_add(y, set(g[1]), set(g[2]))), w);
    const V v = hn::Mul(mul_add(x, set(g[3]), mul_add(y, set(g[4]), set(g[5]))), w);
    // Gradients of u and v, cells per unit of the frame, without the common factor w.
    const V ux = hn::Sub(set(g[0]), hn::Mul(u, set(g[6])));
    const V uy = hn::Sub(set(g[1]), hn::Mul(u, set(g[7])));
    const V vx = hn::Sub(set(g[3]), hn::Mul(v, set(g[6])));
    const V vy = hn::Sub(set(g[4]), hn::Mul(v, set(g[7])));
    const V per_u = hn::Div(one, hn::Sqrt(mul_add(ux, ux, hn::Mul(uy, uy))));
    const V per_v = hn::Div(one, hn::Sqrt(mul_add(vx, vx, hn::Mul(vy, vy))));
    const V scale = hn::Div(set(c.scale), w);
    hn::StoreU(hn::Mul(scale, per_u), d, pixels.across_x.data() + i);
    hn::StoreU(hn::Mul(scale, per_v), d, pixels.across_y.data() + i);
    hn::StoreU(hn::Mul(hn::Mul(per_u, per_v), mul_add(ux, vx, hn::Mul(uy, vy))), d,
               pixels.cosine.data() + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {
namespace {

HWY_EXPORT(choose_in_row);
HWY_EXPORT(measure_grid);

/// Rows of the image that a region touches: [first, end).
struct Rows {
  int first = 0;
  int end = 0;
};

Rows rows_of(ImageView image, const Corners& region) {
  double top = region[0].y;
  double bottom = region[0].y;
  for (const Point p : region) {
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  const double height = image.height;
  return {static_cast<int>(std::clamp(std::floor(top - 0.5), 0.0, height)),
          static_cast<int>(std::clamp(std::ceil(bottom + 0.5), 0.0, height))};
}

/// A convex region cut into rows.
class RegionRows {
 public:
  RegionRows(ImageView image, const Corners& region, int step)
      : width_(image.width), step_(step), turn_(std::max(1, (step * 3 + 4) / 8)) {
    for (int i = 0; i < 4; ++i) {
      const Point a = region[i];
      const Point b = region[(i + 1) % 4];
      const double slope = (b.x - a.x) / (b.y - a.y);
      sides_[i] = {std::min(a.y, b.y), std::max(a.y, b.y), a.x - slope * a.y, slope};
    }
  }

  /// Pixels of row y whose centres lie in the region, one in `step`; rows begin in different
  /// places, so that no direction of edges is left out.
  RowPixels row(int y) const {
    const double middle = y + 0.5;
    double left = width_;
    double right = 0;
    for (const Side& side : sides_) {
      if (middle < side.top || middle >= side.bottom) continue;
      const double x = side.at_zero + side.slope * middle;
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int begin = static_cast<int>(std::max(0.0, left - 0.5) + 0.999999);
    const int end = static_cast<int>(std::min<double>(right, width_) + 0.5);
    // Steps near 0.38 of a period fill it evenly, row by row.
    const int wanted = (y % step_) * turn_ - begin;
    const int first = begin + (wanted % step_ + step_) % step_;
    return {first, step_, first < end ? (end - first + step_ - 1) / step_ : 0};
  }

 private:
  struct Side {
    double top, bottom, at_zero, slope;
  };

  int width_;
  int step_;
  int turn_;
  std::array<Side, 4> sides_{};
};

}  // namespace

std::size_t most_pixels(ImageView image, const Corners& region, int step) {
  const RegionRows rows_of_region(image, region, step);
  std::size_t sum = 0;
  const Rows rows = rows_of(image, region);
  for (int y = rows.first; y < rows.end; ++y) {
    sum += static_cast<std::size_t>(rows_of_region.row(y).count);
  }
  return sum;
}

void choose_pixels(ImageView image, const TagPattern& pattern, const PixelChoice& choice,
                   const Corners& region, PhotometricPixels& pixels) {
  RowChoice row_choice{};
  for (int i = 0; i < 8; ++i) row_choice.to_cells[i] = static_cast<float>(choice.to_cells[i]);
  row_choice.origin_x = static_cast<float>(choice.frame.origin.x);
  row_choice.per_scale = static_cast<float>(1 / choice.frame.scale_px);
  row_choice.scale = static_cast<float>(choice.frame.scale_px);
  row_choice.near_px = static_cast<float>(choice.near_px);
  row_choice.per_spread = static_cast<float>(1 / choice.spread_px);
  row_choice.last_cell = static_cast<float>(pattern.width() - 1);
  row_choice.across_x = static_cast<float>(choice.frame.scale_px /
                                           std::hypot(choice.to_cells[0], choice.to_cells[1]));
  row_choice.across_y = static_cast<float>(choice.frame.scale_px /
                                           std::hypot(choice.to_cells[3], choice.to_cells[4]));
  row_choice.edges = pattern.edges();
  row_choice.flags = pattern.flags().data();
  row_choice.width = pattern.width();
  const int words = words_for_edges(pattern.edges());
  const Rows rows = rows_of(image, region);
  const RegionRows rows_of_region(image, region, choice.step);
  std::vector<std::int32_t>& columns = pixels.columns;
  for (int y = rows.first; y < rows.end; ++y) {
    const RowPixels row = rows_of_region.row(y);
    if (row.count == 0 || pixels.size() + row.count > pixels.capacity()) continue;
    row_choice.y = static_cast<float>((y + 0.5 - choice.frame.origin.y) / choice.frame.scale_px);
    const std::size_t chosen =
        HWY_DYNAMIC_DISPATCH(choose_in_row)(row_choice, row, pixels, columns.data());
    const std::uint8_t* grays = image.row(y);
    for (std::size_t i = 0; i < chosen; ++i) {
      const std::size_t at = pixels.size() + i;
      pixels.y[at] = row_choice.y;
      pixels.gray[at] = grays[columns[i]];
      const CellSurroundings& around = pattern.surroundings(static_cast<int>(pixels.line_x[at]),
                                                            static_cast<int>(pixels.line_y[at]));
      for (int k = 0; k < words; ++k) pixels.pattern[k][at] = around.words[k];
    }
    pixels.grow(chosen);
  }
  pixels.pad();
  HWY_DYNAMIC_DISPATCH(measure_grid)(row_choice, pixels);
}

namespace scalar {
namespace {

/// Distance to the nearest side of a cell that has its flag, px; nothing flagged is far away.
double nearest_side(std::int32_t flags, const std::array<std::int32_t, 4>& sides,
                    const std::array<double, 4>& distances) {
  double nearest = 1e9;
  for (int k = 0; k < 4; ++k) {
    if ((flags & sides[k]) != 0) nearest = std::min(nearest, distances[k]);
  }
  return nearest;
}

/// Whether the pixel takes part; fills in all but its gray value.
bool choose_pixel(const TagPattern& pattern, const PixelChoice& choice, Point at,
                  double ideal_px_per_px, PhotometricPixel& pixel) {
  const auto& g = choice.to_cells;
  const Point p = choice.frame.to_frame(at);
  const double w = 1 / (g[6] * p.x + g[7] * p.y + 1);
  const double u = (g[0] * p.x + g[1] * p.y + g[2]) * w;
  const double v = (g[3] * p.x + g[4] * p.y + g[5]) * w;
  const double width = pattern.width();
  if (!(w > 0 && u >= 0 && v >= 0 && u < width && v < width)) return false;
  pixel.x = p.x;
  pixel.y = p.y;
  const int cell_x = static_cast<int>(u);
  const int cell_y = static_cast<int>(v);
  pixel.line_x = pattern.first_line(u, cell_x);
  pixel.line_y = pattern.first_line(v, cell_y);
  const double scale = choice.frame.scale_px / (w * ideal_px_per_px);
  const Point across_u{g[0] - u * g[6], g[1] - u * g[7]};
  const Point across_v{g[3] - v * g[6], g[4] - v * g[7]};
  pixel.across_x = scale / length(across_u);
  pixel.across_y = scale / length(across_v);
  pixel.cosine = dot(across_u, across_v) / (length(across_u) * length(across_v));
  const double in_x = u - cell_x;
  const double in_y = v - cell_y;
  const double middle_x = choice.frame.scale_px / std::hypot(g[0], g[1]);
  const double middle_y = choice.frame.scale_px / std::hypot(g[3], g[4]);
  const std::array<double, 4> sides = {in_x * middle_x, (1 - in_x) * middle_x, in_y * middle_y,
                                       (1 - in_y) * middle_y};
  const std::int32_t flags = pattern.flags()[pattern.index(cell_x, cell_y)];
  if (nearest_side(flags,
                   {TagPattern::kChangeLeft, TagPattern::kChangeRight, TagPattern::kChangeUp,
                    TagPattern::kChangeDown},
                   sides) > choice.near_px) {
    return false;
  }
  const double unknown = nearest_side(flags,
                                      {TagPattern::kUnknownLeft, TagPattern::kUnknownRight,
                                       TagPattern::kUnknownUp, TagPattern::kUnknownDown},
                                      sides);
  const double share = edge_profile(-unknown / choice.spread_px).share / double{kUnknownShare};
  pixel.weight = 1 / (1 + share * share);
  return true;
}

}  // namespace

void choose_pixels(ImageView image, const TagPattern& pattern, const PixelChoice& choice,
                   const Corners& region, const PixelMapping* mapping, PhotometricPixels& pixels) {
  const Rows rows = rows_of(image, region);
  const RegionRows rows_of_region(image, region, choice.step);
  for (int y = rows.first; y < rows.end; ++y) {
    const RowPixels row = rows_of_region.row(y);
    for (int k = 0; k < row.count && pixels.size() < pixels.capacity(); ++k) {
      const int x = row.x0 + k * row.step;
      const Point centre{x + 0.5, y + 0.5};
      PhotometricPixel pixel;
      if (!choose_pixel(pattern, choice, mapping ? mapping->to_ideal(centre) : centre,
                        mapping ? mapping->ideal_px_per_px : 1, pixel)) {
        continue;
      }
      pixel.gray = image.at(x, y);
      pixels.add(pixel, pattern.surroundings(pixel.line_x, pixel.line_y));
    }
  }
  pixels.pad();
}

}  // namespace scalar
}  // namespace tagmint::detect
#endif  // HWY_ONCE
