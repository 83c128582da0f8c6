#pragma once

#include <array>

namespace tagmint::detect {

/// How an edge looks through a camera: the share of white at a place t standard deviations of the
/// point-spread to the white side of the edge, from 0 at -kEdgeReach to 1 at kEdgeReach.
///
/// An odd polynomial of degree nine about 1/2, P(t) + tails * D(t). P is the one nearest to the
/// integral of the normal density that ends at +-1/2 with no slope: within 0.002 of it, its slope
/// within 0.0045 of the density. D leads from there to point-spreads with a higher peak and longer
/// tails (at tails = 1 an excess kurtosis of about two). No exponential is needed, and nothing
/// beyond the reach.
inline constexpr double kEdgeReach = 3.0;
/// P(t) = c0 t + c1 t^3 + ... + c4 t^9.
inline constexpr std::array<double, 5> kEdgeTerms = {0.3969916898131892, -0.06234390254946381,
                                                     0.007457070750975877, -0.000497567698320062,
                                                     1.3637284109890999e-05};
/// D(t), alike.
inline constexpr std::array<double, 5> kTailTerms = {0.12428484907447179, -0.09614052284659412,
                                                     0.023930914641597772, -0.0024391679717128715,
                                                     8.851230330043275e-05};

struct EdgeValue {
  double share = 0;     ///< of white, 0..1
  double slope = 0;     ///< d share / d t
  double by_tails = 0;  ///< d share / d tails
};

/// The profile at t; constant outside +-kEdgeReach.
constexpr EdgeValue edge_profile(double t, double tails = 0) {
  if (t <= -kEdgeReach) return {0, 0, 0};
  if (t >= kEdgeReach) return {1, 0, 0};
  const double s = t * t;
  EdgeValue value;
  for (int k = 4; k >= 0; --k) {
    const double term = kEdgeTerms[k] + tails * kTailTerms[k];
    value.share = value.share * s + term;
    value.slope = value.slope * s + (2 * k + 1) * term;
    value.by_tails = value.by_tails * s + kTailTerms[k];
  }
  return {0.5 + t * value.share, value.slope, t * value.by_tails};
}

}  // namespace tagmint::detect
