#include "refine/photometric_model.h"

#include <cmath>

#include "refine/edge_profile.h"

namespace tagmint::detect {
namespace {

/// M(a, b) of the cells around one, signed four-bit numbers.
int mixed_difference(const CellSurroundings& around, int code) {
  const std::uint32_t bits = around.words[code / kCodesPerWord] >> (4 * (code % kCodesPerWord));
  return static_cast<int>((bits & 0xf) ^ 8) - 8;
}

/// P_0 .. P_edges at a place, and their derivatives by the place (in cells), by ln of the spread
/// and by tails.
struct EdgeRow {
  std::array<double, kSmallCells + 1> share{1};
  std::array<double, kSmallCells + 1> by_place{};
  std::array<double, kSmallCells + 1> by_spread{};
  std::array<double, kSmallCells + 1> by_tails{};
};

///   beyond       place from the first grid line, cells
///   per_spread   standard deviations from one grid line to the next
EdgeRow edges_around(double beyond, double per_spread, double tails, int edges) {
  EdgeRow row;
  for (int a = 1; a <= edges; ++a) {
    const double t = (beyond + 1 - a) * per_spread;
    const EdgeValue edge = edge_profile(t, tails);
    row.share[a] = edge.share;
    row.by_place[a] = edge.slope * per_spread;
    row.by_spread[a] = -t * edge.slope;
    row.by_tails[a] = edge.by_tails;
  }
  return row;
}

/// Share of white at a pixel, and its derivatives.
struct Whiteness {
  double share = 0;
  double by_x = 0;  // by the place, in cells
  double by_y = 0;
  double by_spread = 0;
  double by_tails = 0;
};

///   per_x, per_y   standard deviations from one grid line to the next
///   cosine         where the grid lines are not at right angles, blur across x goes with blur
///   across
///                  y: two terms of the series of the bivariate normal integral in it
Whiteness mix(const CellSurroundings& around, int edges, const EdgeRow& x, const EdgeRow& y,
              double per_x, double per_y, double cosine) {
  Whiteness sum;
  const int side = edges + 1;
  for (int b = 0; b < side; ++b) {
    for (int a = 0; a < side; ++a) {
      // Half, because brightness counts twice.
      const double m = 0.5 * mixed_difference(around, a + b * side);
      sum.share += m * x.share[a] * y.share[b];
      sum.by_x += m * x.by_place[a] * y.share[b];
      sum.by_y += m * x.share[a] * y.by_place[b];
      sum.by_spread += m * (x.by_spread[a] * y.share[b] + x.share[a] * y.by_spread[b]);
      sum.by_tails += m * (x.by_tails[a] * y.share[b] + x.share[a] * y.by_tails[b]);
      const double density_x = x.by_place[a] / per_x;
      const double density_y = y.by_place[b] / per_y;
      sum.share +=
          m * cosine * (density_x * density_y + cosine / 2 * x.by_spread[a] * y.by_spread[b]);
      sum.by_x += m * cosine * per_x * x.by_spread[a] * density_y;
      sum.by_y += m * cosine * per_y * density_x * y.by_spread[b];
    }
  }
  return sum;
}

}  // namespace

PhotometricParameters moved(const PhotometricParameters& parameters,
                            const PhotometricVector& step) {
  PhotometricParameters p = parameters;
  for (int i = 0; i < 8; ++i) p.to_cells[i] += step[i];
  p.black += step[kBlackLevel];
  p.contrast += step[kContrast];
  p.light_x += step[kLightX];
  p.light_y += step[kLightY];
  p.log_spread += step[kLogSpread];
  p.tails += step[kTails];
  p.tone += step[kTone];
  return p;
}

PhotometricPrediction predict(const TagPattern& pattern, const PhotometricPixel& pixel,
                              const PhotometricParameters& parameters) {
  const std::array<double, 8>& g = parameters.to_cells;
  const double w = 1 / (g[6] * pixel.x + g[7] * pixel.y + 1);
  const double u = (g[0] * pixel.x + g[1] * pixel.y + g[2]) * w;
  const double v = (g[3] * pixel.x + g[4] * pixel.y + g[5]) * w;
  const double per_px = std::exp(-parameters.log_spread);
  const int edges = pattern.edges();
  const double per_x = pixel.across_x * per_px;
  const double per_y = pixel.across_y * per_px;
  const Whiteness white = mix(pattern.surroundings(pixel.line_x, pixel.line_y), edges,
                              edges_around(u - pixel.line_x, per_x, parameters.tails, edges),
                              edges_around(v - pixel.line_y, per_y, parameters.tails, edges), per_x,
                              per_y, pixel.cosine);

  const double t = white.share;
  const double toned = t + parameters.tone * t * (1 - t);
  const double light = 1 + parameters.light_x * pixel.x + parameters.light_y * pixel.y;
  const double in_full_light = parameters.black + parameters.contrast * toned;
  const double by_share = light * parameters.contrast * (1 + parameters.tone * (1 - 2 * t));

  PhotometricPrediction prediction;
  prediction.gray = light * in_full_light;
  const double by_u = by_share * white.by_x * w;
  const double by_v = by_share * white.by_y * w;
  const double by_w = -(by_u * u + by_v * v);
  prediction.slope = {by_u * pixel.x,
                      by_u * pixel.y,
                      by_u,
                      by_v * pixel.x,
                      by_v * pixel.y,
                      by_v,
                      by_w * pixel.x,
                      by_w * pixel.y,
                      light,
                      light * toned,
                      pixel.x * in_full_light,
                      pixel.y * in_full_light,
                      by_share * white.by_spread,
                      by_share * white.by_tails,
                      light * parameters.contrast * t * (1 - t)};
  return prediction;
}

}  // namespace tagmint::detect
