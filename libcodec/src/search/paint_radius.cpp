#include "search/paint_radius.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "search/tree_order.h"

namespace tagmint::codec {
namespace {

/// probabilities[d]: share of all words of `bits` bits at distance d from a given one.
std::vector<double> distance_shares(int bits) {
  std::vector<double> shares(bits + 1);
  shares[0] = std::ldexp(1.0, -bits);
  for (int d = 1; d <= bits; ++d) shares[d] = shares[d - 1] * (bits - d + 1) / d;
  return shares;
}

}  // namespace

int best_paint_radius(int bits, int radius, std::size_t turns) {
  // Measured in units of one comparison vector: a ball costs eight loads and ORs, a word left open
  // is collected and compared with lists that grow as the radius asked for falls.
  constexpr double kBallCost = 8;
  constexpr double kOpenWordCost = 40;
  constexpr double kWords = 1 << TreeOrder::kLeafBits;
  const std::vector<double> above = distance_shares(bits - TreeOrder::kLeafBits);
  const std::vector<double> within = distance_shares(TreeOrder::kLeafBits);

  int best = radius;
  double least_cost = std::numeric_limits<double>::infinity();
  double painted = 0;   // balls for each leaf
  double log_open = 0;  // logarithm of the share of words left open
  for (int left = radius; left >= 0; --left) {
    const int distance = radius - left;
    if (distance >= static_cast<int>(above.size())) break;
    const double balls = static_cast<double>(turns) * above[distance];
    double ball_share = 0;
    for (int d = 0; d <= std::min(left, TreeOrder::kLeafBits); ++d) ball_share += within[d];
    painted += balls;
    log_open += balls * std::log1p(-std::min(ball_share, 1 - 1e-12));
    const double cost = kBallCost * painted + kOpenWordCost * kWords * std::exp(log_open);
    if (cost < least_cost) {
      least_cost = cost;
      best = left;
    }
  }
  return best;
}

}  // namespace tagmint::codec
