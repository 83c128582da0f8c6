#include "tagmint/codec/family_stats.h"

#include <algorithm>
#include <cmath>

#include "pair_distances.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// Index of the first entry that is not zero; `none` when all are.
int first_used(const std::vector<std::uint64_t>& histogram, int none) {
  const auto used = std::find_if(histogram.begin(), histogram.end(), [](auto n) { return n > 0; });
  return used == histogram.end() ? none : static_cast<int>(used - histogram.begin());
}

/// 4 * codes * sum_{i <= r} C(bits, i) / 2^bits for r = 0 .. bits / 2, each at most 1.
std::vector<double> false_accept_rates(std::size_t codes, int bits) {
  std::vector<double> rates;
  double words_at_distance = 1;  // C(bits, r), exact in a double up to 2^53 and near enough beyond
  double words_within = 0;
  for (int r = 0; r <= bits / 2; ++r) {
    words_within += words_at_distance;
    const double share = 4.0 * static_cast<double>(codes) * std::ldexp(words_within, -bits);
    rates.push_back(std::min(1.0, share));
    words_at_distance = words_at_distance * (bits - r) / (r + 1);
  }
  return rates;
}

}  // namespace

FamilyStats family_stats(const Family& family, int threads) {
  const int bits = family.bits();
  const std::size_t entries = static_cast<std::size_t>(bits) + 1;
  const Level all{family.size(), family.min_hamming()};
  const DistanceHistogram pairs =
      pair_histograms(family.codewords(), bits, std::span(&all, 1), threads).front();

  FamilyStats stats;
  stats.distance_histogram.assign(pairs.begin(), pairs.begin() + bits + 1);
  stats.self_histogram.assign(entries, 0);
  for (const Codeword word : family.codewords()) ++stats.self_histogram[self_distance(word, bits)];
  stats.min_hamming =
      std::min(first_used(stats.distance_histogram, bits), first_used(stats.self_histogram, bits));
  stats.false_accept_rate = false_accept_rates(family.size(), bits);
  return stats;
}

}  // namespace tagmint::codec
