#include "search/linear_programming_bound.h"

#include <cstdint>
#include <vector>

#include "search/dense_simplex.h"

namespace tagmint::codec {

namespace {

/// More than all rounding errors of a sum of less than 100 terms add up to, relative to the sum of
/// their magnitudes: 100 times 2^-112.
constexpr Quad kRounding = Quad{1} / (WideCount{1} << 100);

/// K_0(i), K_1(i), ..., K_n(i): the coefficients of (1 - z)^i (1 + z)^(n - i).
std::vector<std::int64_t> krawtchouk(int bits, int i) {
  std::vector<std::int64_t> coefficients(bits + 1, 0);
  coefficients[0] = 1;
  for (int factor = 0; factor < bits; ++factor) {
    for (int k = factor + 1; k > 0; --k) {
      coefficients[k] += factor < i ? -coefficients[k - 1] : coefficients[k - 1];
    }
  }
  return coefficients;
}

/// A distance that two words of the code can have.
struct Distance {
  Quad most;                 ///< A_i is not larger
  std::vector<Quad> scaled;  ///< K_k(i) / C(n, k), within -1..1; index k - 1
};

/// All words may be taken to have even weight (the last bit as a parity bit), so only even
/// distances occur; for them K_(n - k) = K_k, so that k <= n / 2 says everything.
std::vector<Distance> distances(int bits, int even_distance, const ConstantWeightBounds& weights) {
  std::vector<Distance> distances;
  for (int i = even_distance; i <= bits; i += 2) {
    const std::vector<std::int64_t> values = krawtchouk(bits, i);
    Distance& distance = distances.emplace_back();
    distance.most = static_cast<Quad>(weights.at(bits, i));
    for (int k = 1; k <= bits / 2; ++k) {
      distance.scaled.push_back(static_cast<Quad>(values[k]) /
                                static_cast<Quad>(binomial(bits, k)));
    }
  }
  return distances;
}

/// Largest sum of A_i with sum of A_i * -scaled_k(i) <= 1 for each k, and A_i <= most.
LinearProgram program_of(const std::vector<Distance>& distances) {
  const std::size_t columns = distances.size();
  const std::size_t inequalities = distances.front().scaled.size();
  LinearProgram program;
  program.gains.assign(columns, 1);
  program.limits.assign(inequalities, 1);
  program.matrix.assign(inequalities + columns, std::vector<Quad>(columns, 0));
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t k = 0; k < inequalities; ++k) program.matrix[k][i] = -distances[i].scaled[k];
    program.matrix[inequalities + i][i] = 1;
    program.limits.push_back(distances[i].most);
  }
  return program;
}

/// With any prices >= 0 for Delsarte's inequalities and f(i) = 1 + sum over k of prices_k
/// scaled_k(i),
///     1 + sum of A_i <= 1 + sum of A_i + sum over k of prices_k (1 + sum over i of A_i
///     scaled_k(i))
///                     = 1 + sum of prices + sum of A_i f(i)
///                    <= 1 + sum of prices + sum of max(0, f(i)) most(i).
Quad proven_bound(const std::vector<Quad>& prices, const std::vector<Distance>& distances) {
  const std::size_t inequalities = distances.front().scaled.size();
  Quad total = 1;
  for (std::size_t k = 0; k < inequalities; ++k) total += prices[k];
  Quad bound = total;
  for (const Distance& distance : distances) {
    Quad excess = 1 + kRounding * total;
    for (std::size_t k = 0; k < inequalities; ++k) excess += prices[k] * distance.scaled[k];
    if (excess > 0) bound += excess * distance.most;
  }
  return bound + bound * kRounding;
}

}  // namespace

WideCount linear_programming_bound(int bits, int even_distance,
                                   const ConstantWeightBounds& weights) {
  const std::vector<Distance> all = distances(bits, even_distance, weights);
  const Quad bound = proven_bound(dual_prices(program_of(all)), all);
  const WideCount all_words = WideCount{1} << bits;
  return bound < static_cast<Quad>(all_words) ? static_cast<WideCount>(bound) : all_words;
}

}  // namespace tagmint::codec
