#include "search/word_bounds.h"

#include <algorithm>
#include <array>

namespace tagmint::codec {

namespace {

constexpr int kMostBits = 65;
using Triangle = std::array<std::array<WideCount, kMostBits + 1>, kMostBits + 1>;

constexpr Triangle pascal_triangle() {
  Triangle rows = {};
  for (int from = 0; from <= kMostBits; ++from) {
    rows[from][0] = 1;
    for (int chosen = 1; chosen <= from; ++chosen) {
      rows[from][chosen] = rows[from - 1][chosen - 1] + rows[from - 1][chosen];
    }
  }
  return rows;
}

constexpr Triangle kBinomials = pascal_triangle();

/// Words of weight w that share at most w - d/2 ones pairwise: with M words a column of n has
/// M w / n ones on the average, so that the pairs share at least n (M w / n)(M w / n - 1) / 2 ones;
/// solved for M. Nothing where the pairs may share that many for every M.
WideCount column_count_bound(int bits, int distance, int weight) {
  const int half = distance / 2;
  const int surplus = weight * weight - weight * bits + half * bits;
  return surplus > 0 ? static_cast<WideCount>(half * bits / surplus) : binomial(bits, weight);
}

}  // namespace

WideCount binomial(int from, int chosen) {
  return chosen < 0 || chosen > from ? WideCount{0} : kBinomials[from][chosen];
}

ConstantWeightBounds::ConstantWeightBounds(int most_bits, int even_distance) {
  for (int bits = 0; bits <= most_bits; ++bits) {
    std::vector<WideCount>& row = bounds_.emplace_back(bits + 1, 1);
    for (int weight = 0; weight <= bits; ++weight) {
      if (2 * std::min(weight, bits - weight) < even_distance) continue;
      // The words that have a one (a zero) at a place, counted over all places.
      const std::vector<WideCount>& shorter = bounds_[bits - 1];
      row[weight] =
          std::min({shorter[weight - 1] * bits / weight, shorter[weight] * bits / (bits - weight),
                    column_count_bound(bits, even_distance, weight)});
    }
  }
}

WideCount singleton_bound(int bits, int even_distance) {
  return WideCount{1} << (bits - even_distance + 1);
}

WideCount sphere_packing_bound(int bits, int even_distance) {
  WideCount ball = 0;
  for (int i = 0; i < even_distance / 2; ++i) ball += binomial(bits - 1, i);
  return (WideCount{1} << (bits - 1)) / ball;
}

WideCount plotkin_bound(int bits, int even_distance) {
  if (2 * even_distance > bits) return 2 * (even_distance / (2 * even_distance - bits));
  return 2 * even_distance == bits ? WideCount(4 * even_distance) : WideCount{1} << bits;
}

WideCount johnson_bound(int bits, int even_distance, const ConstantWeightBounds& weights) {
  // Around words at distance d - 1: each word just outside a ball, at distance d/2 of its centre,
  // is outside all balls unless one of the A(n, d, d - 1) words at distance d - 1 of the centre has
  // it, each C(d - 1, d/2 - 1) of them; and it is at distance d/2 of at most n / (d/2) centres.
  const int half = even_distance / 2;
  const int n = bits - 1;
  WideCount ball = 0;
  for (int i = 0; i < half; ++i) ball += binomial(n, i);
  const WideCount shell = binomial(n, half);
  const WideCount taken = binomial(even_distance - 1, half - 1) * weights.at(n, even_distance - 1);
  const WideCount outside = shell > taken ? shell - taken : 0;
  const WideCount shared = n / half;
  if (shared == 0) return (WideCount{1} << n) / ball;
  return (WideCount{1} << n) * shared / (ball * shared + outside);
}

}  // namespace tagmint::codec
